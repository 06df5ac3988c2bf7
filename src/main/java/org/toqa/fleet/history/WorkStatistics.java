package org.toqa.fleet.history;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * What happened in some time, in numbers.
 *
 * @param waiting from order to the first robots, over the tasks that got them then; null: none did
 * @param delivery from order to delivery, over the tasks that were delivered then
 * @param completion from order to the end, over the tasks that were done then
 * @param orderError how far the delivery that was expected at the order was from what came, over
 *     the tasks that were delivered then and of which it was said; null: of none
 * @param startError the same of what was expected when robots had just got it
 * @param metres that all robots drove
 * @param battery the sum of all falls of charge of all batteries, as a share of a full one; at
 *     least 0
 * @param failures how often; every kind is there
 */
public record WorkStatistics(
    long ordered,
    long done,
    long failed,
    long cancelled,
    @Nullable DurationStatistics waiting,
    @Nullable DurationStatistics delivery,
    @Nullable DurationStatistics completion,
    @Nullable DurationStatistics orderError,
    @Nullable DurationStatistics startError,
    double metres,
    double battery,
    Map<FailureKind, Long> failures) {

  /** What has failed, counted; not what was meant so. */
  public long failureCount() {
    return failures.entrySet().stream()
        .filter(failure -> !failure.getKey().isPlanned())
        .mapToLong(Map.Entry::getValue)
        .sum();
  }
}
