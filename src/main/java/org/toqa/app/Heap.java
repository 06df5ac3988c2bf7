package org.toqa.app;

import java.lang.management.ManagementFactory;

/** The memory of this process. */
final class Heap {
  private Heap() {}

  /** What is still in use after the garbage is collected, in 10^6 bytes. */
  static double usedMegabytes() {
    System.gc();
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() / 1e6;
  }
}
