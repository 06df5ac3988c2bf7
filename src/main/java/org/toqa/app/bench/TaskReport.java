package org.toqa.app.bench;

import java.time.Duration;
import java.util.Collection;
import java.util.HashSet;
import org.toqa.statistics.Percentiles;

/**
 * What came of putting tasks in.
 *
 * @param lost how many were accepted and are not there
 * @param twice how many are there once too often
 * @param heapMb megabytes that are still in use
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
   * @param millis of each task that was timed
   * @param others how many were not
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
