package org.toqa.app.bench;

import java.time.Duration;
import java.util.Collection;
import java.util.HashSet;
import org.toqa.app.bench.meter.HeapMemory;
import org.toqa.statistics.Percentiles;

/**
 * What a bench prints of submitting tasks.
 *
 * @param tasks how many were timed
 * @param clients how many submitted them at once
 * @param seconds that it took
 * @param p50Ms median response time, milliseconds
 * @param p99Ms 99th percentile, milliseconds
 * @param maxMs the longest, milliseconds
 * @param lost how many were accepted and are not there
 * @param twice how many are there more than once
 * @param heapMb heap in use, in units of 10^6 bytes, after a garbage collection
 */
record TaskReport(
    int tasks,
    int clients,
    double seconds,
    double tasksPerSecond,
    double p50Ms,
    double p99Ms,
    double maxMs,
    int lost,
    int twice,
    double heapMb) {

  /**
   * @param millis response time of each task that was timed, milliseconds
   * @param others how many were submitted and not timed
   * @param took how long the timed ones took together
   * @param names of the tasks that are there; each task had a name of its own
   */
  static TaskReport of(
      double[] millis, int others, Duration took, int clients, Collection<String> names) {
    Percentiles timings = new Percentiles(millis);
    double seconds = took.toNanos() / 1e9;
    int different = new HashSet<>(names).size();
    return new TaskReport(
        millis.length,
        clients,
        seconds,
        millis.length / seconds,
        timings.percentile(0.5),
        timings.percentile(0.99),
        timings.max(),
        others + millis.length - different,
        names.size() - different,
        HeapMemory.usedMegabytes());
  }
}
