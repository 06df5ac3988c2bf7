package org.toqa.app.bench.meter;

import java.lang.management.ManagementFactory;

/** The memory of this process. */
public final class HeapMemory {
  private HeapMemory() {}

  /** Heap in use after a garbage collection, in units of 10^6 bytes. */
  public static double usedMegabytes() {
    System.gc();
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() / 1e6;
  }
}
