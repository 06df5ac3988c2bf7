package org.toqa.app.bench;

import java.lang.management.ManagementFactory;

/** How long a thread has worked: what others do on the machine is not in it. */
final class ProcessorTime {
  private ProcessorTime() {}

  /** Milliseconds that the calling thread has worked since it began. */
  static double millis() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() / 1e6;
  }
}
