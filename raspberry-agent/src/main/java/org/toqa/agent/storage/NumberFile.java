package org.toqa.agent.storage;

import java.io.IOException;
import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.VarHandle;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/**
 * Numbers that are kept together, at every tick, and outlive the process.
 *
 * <p>The file is mapped into memory, so that keeping them costs no call to the system and a killed
 * process leaves the last whole ones. Two slots are written in turn, then the count that names the
 * valid one; a crash between the two leaves the earlier slot valid. After a loss of power they may
 * be some seconds old.
 */
public final class NumberFile implements AutoCloseable {

  private static final VarHandle COUNT = ValueLayout.JAVA_LONG.varHandle();

  private final Arena arena = Arena.ofShared();
  private final MemorySegment memory;
  private final long slotBytes;

  /**
   * @param numbers how many there are
   */
  public NumberFile(Path file, int numbers) throws IOException {
    slotBytes = (long) numbers * Double.BYTES;
    try (FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
      memory = channel.map(FileChannel.MapMode.READ_WRITE, 0, Long.BYTES + 2 * slotBytes, arena);
    }
  }

  /** The same without a file: nothing outlives the process. */
  public NumberFile(int numbers) {
    slotBytes = (long) numbers * Double.BYTES;
    memory = arena.allocate(Long.BYTES + 2 * slotBytes, Long.BYTES);
  }

  /** How often they were written, in all. */
  public long count() {
    return (long) COUNT.getAcquire(memory, 0L);
  }

  /** As they were written last; empty where they never were. */
  public Optional<double[]> read() {
    long count = count();
    return count == 0
        ? Optional.empty()
        : Optional.of(slot(count).toArray(ValueLayout.JAVA_DOUBLE));
  }

  public void write(double... numbers) {
    long next = (long) COUNT.get(memory, 0L) + 1;
    slot(next).copyFrom(MemorySegment.ofArray(numbers));
    COUNT.setRelease(memory, 0L, next);
  }

  @Override
  public void close() {
    arena.close();
  }

  private MemorySegment slot(long count) {
    return memory.asSlice(Long.BYTES + (count & 1) * slotBytes, slotBytes);
  }
}
