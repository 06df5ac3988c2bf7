package org.toqa.app;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;

/** Measures how this process keeps up, from when it is made until it is read. */
final class PaceMeter {
  private final OperatingSystemMXBean system =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
  private final InstantSource fleetTime;
  private final long cpuAtFirst = system.getProcessCpuTime();
  private final long began = System.nanoTime();
  private final Instant fleetBegan;

  /**
   * @param seconds that it took
   * @param pace the fleet's seconds a second; below 1 where the machine cannot keep up
   * @param cores processor seconds a second
   */
  record Reading(double seconds, double pace, double cores) {}

  PaceMeter(InstantSource fleetTime) {
    this.fleetTime = fleetTime;
    this.fleetBegan = fleetTime.instant();
  }

  Reading read() {
    double nanos = System.nanoTime() - began;
    return new Reading(
        nanos / 1e9,
        Duration.between(fleetBegan, fleetTime.instant()).toNanos() / nanos,
        (system.getProcessCpuTime() - cpuAtFirst) / nanos);
  }
}
