package org.toqa.app.bench.meter;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;

/** Measures how this process keeps up, from when it is made until it is read. */
public final class ProcessMeter {
  private final OperatingSystemMXBean system =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
  private final InstantSource fleetClock;
  private final long processorTimeBefore = system.getProcessCpuTime();
  private final long startNanos = System.nanoTime();
  private final Instant fleetStart;

  /**
   * @param seconds of real time that it took
   * @param pace the fleet's seconds a second of real time
   * @param cores processor seconds a second, of the whole process
   */
  public record Reading(double seconds, double pace, double cores) {}

  /**
   * @param fleetTime the fleet's own clock
   */
  public ProcessMeter(InstantSource fleetTime) {
    this.fleetClock = fleetTime;
    this.fleetStart = fleetTime.instant();
  }

  /** What was measured until now; it goes on measuring. */
  public Reading read() {
    double nanos = System.nanoTime() - startNanos;
    return new Reading(
        nanos / 1e9,
        Duration.between(fleetStart, fleetClock.instant()).toNanos() / nanos,
        (system.getProcessCpuTime() - processorTimeBefore) / nanos);
  }
}
