package org.toqa.app.bench;

import java.lang.management.ManagementFactory;

/** The memory of this process. */
final class HeapMemory {
  private HeapMemory() {}

  /** Heap in use after a garbage collection, in units of 10^6 bytes. */
  static double usedMegabytes() {
    System.gc();
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() / 1e6;
  }
}
