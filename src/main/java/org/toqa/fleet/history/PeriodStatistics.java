package org.toqa.fleet.history;

import java.util.List;

/**
 * A period in numbers.
 *
 * @param buckets one for each bucket of the period
 * @param robots those that were recorded, by name
 */
public record PeriodStatistics(
    Period period,
    WorkStatistics total,
    List<WorkStatistics> buckets,
    List<RobotUtilisation> robots) {
  public PeriodStatistics {
    buckets = List.copyOf(buckets);
    robots = List.copyOf(robots);
  }
}
