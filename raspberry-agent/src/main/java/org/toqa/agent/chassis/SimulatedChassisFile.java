package org.toqa.agent.chassis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.toqa.agent.storage.NumberFile;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.WheelSpeeds;

/**
 * Keeps a simulated body while no daemon runs: a body does not vanish when its daemon is killed.
 */
final class SimulatedChassisFile implements AutoCloseable {

  private static final int NUMBERS = 21;

  private final NumberFile file;

  SimulatedChassisFile(Path file) throws IOException {
    this.file = new NumberFile(file, NUMBERS);
  }

  /** A body that nothing of is kept. */
  SimulatedChassisFile() {
    file = new NumberFile(NUMBERS);
  }

  /** How often it was written, in all. */
  long count() {
    return file.count();
  }

  Optional<SimulatedChassisState> read() {
    return file.read().map(SimulatedChassisFile::state);
  }

  private static SimulatedChassisState state(double[] n) {
    return new SimulatedChassisState(
        (long) n[0],
        new Pose(n[1], n[2], n[3]),
        new Pose(n[4], n[5], n[6]),
        new ThreeWheels(n[7], n[8], n[9]),
        new WheelSpeeds(n[10], n[11], n[12]),
        new Pose(n[13], n[14], n[15]),
        new Twist(n[16], n[17], n[18]),
        n[19],
        (long) n[20]);
  }

  void write(SimulatedChassisState b) {
    file.write(
        (double) b.powerCycle(),
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
        (double) b.steps());
  }

  @Override
  public void close() {
    file.close();
  }
}
