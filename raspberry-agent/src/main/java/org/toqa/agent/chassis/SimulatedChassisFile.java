package org.toqa.agent.chassis;

import java.io.IOException;
import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.VarHandle;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.WheelSpeeds;

/**
 * Keeps a simulated body while no daemon runs: a body does not vanish when its daemon is killed.
 *
 * <p>The file is mapped into memory, so that keeping the body costs no call to the system and a
 * killed process leaves its last whole state. Two slots are written in turn, then the count that
 * names the valid one; a crash between the two leaves the earlier slot valid.
 */
final class SimulatedChassisFile implements AutoCloseable {

  private static final int NUMBERS = 21;
  private static final long SLOT_BYTES = NUMBERS * Double.BYTES;
  private static final VarHandle COUNT = ValueLayout.JAVA_LONG.varHandle();

  private final Arena arena = Arena.ofShared();
  private final MemorySegment memory;

  SimulatedChassisFile(Path file) throws IOException {
    try (FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
      memory = channel.map(FileChannel.MapMode.READ_WRITE, 0, Long.BYTES + 2 * SLOT_BYTES, arena);
    }
  }

  /** A body that nothing of is kept. */
  SimulatedChassisFile() {
    memory = arena.allocate(Long.BYTES + 2 * SLOT_BYTES, Long.BYTES);
  }

  /** How often it was written, in all. */
  long count() {
    return (long) COUNT.getAcquire(memory, 0L);
  }

  Optional<SimulatedChassisState> read() {
    long count = count();
    if (count == 0) {
      return Optional.empty();
    }
    double[] n = slot(count).toArray(ValueLayout.JAVA_DOUBLE);
    return Optional.of(
        new SimulatedChassisState(
            (long) n[0],
            new Pose(n[1], n[2], n[3]),
            new Pose(n[4], n[5], n[6]),
            new ThreeWheels(n[7], n[8], n[9]),
            new WheelSpeeds(n[10], n[11], n[12]),
            new Pose(n[13], n[14], n[15]),
            new Twist(n[16], n[17], n[18]),
            n[19],
            (long) n[20]));
  }

  void write(SimulatedChassisState b) {
    double[] numbers = {
      b.powerCycle(),
      b.start().x(),
      b.start().y(),
      b.start().theta(),
      b.truePose().x(),
      b.truePose().y(),
      b.truePose().theta(),
      b.wheelTurns().one(),
      b.wheelTurns().two(),
      b.wheelTurns().three(),
      b.wheelSpeeds().first(),
      b.wheelSpeeds().second(),
      b.wheelSpeeds().third(),
      b.odometry().x(),
      b.odometry().y(),
      b.odometry().theta(),
      b.command().vx(),
      b.command().vy(),
      b.command().w(),
      b.battery(),
      b.steps()
    };
    long next = (long) COUNT.get(memory, 0L) + 1;
    slot(next).copyFrom(MemorySegment.ofArray(numbers));
    COUNT.setRelease(memory, 0L, next);
  }

  @Override
  public void close() {
    arena.close();
  }

  private MemorySegment slot(long count) {
    return memory.asSlice(Long.BYTES + (count & 1) * SLOT_BYTES, SLOT_BYTES);
  }
}
