package org.toqa.store;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * What happened in some time, in numbers.
 *
 * @param waiting from order to the first robots, over the tasks that got them then; null: none did
 * @param delivery from order to delivery, over the tasks that were delivered then
 * @param completion from order to the end, over the tasks that were done then
 * @param metres that all robots drove
 * @param battery how much all batteries fell; 1 is a full one
 * @param failures how often; every kind is there
 */
public record Figures(
    long ordered,
    long done,
    long failed,
    long cancelled,
    @Nullable Spread waiting,
    @Nullable Spread delivery,
    @Nullable Spread completion,
    double metres,
    double battery,
    Map<Failure, Long> failures) {

  public long failureCount() {
    return failures.values().stream().mapToLong(Long::longValue).sum();
  }
}
