package org.toqa.app.bench.meter;

import java.lang.management.ManagementFactory;

/** Processor time of one thread: other work on the machine does not count. */
public final class ProcessorTime {
  private ProcessorTime() {}

  /** Processor time of the calling thread since it began, milliseconds. */
  public static double millis() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() / 1e6;
  }
}
