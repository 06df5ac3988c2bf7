package org.toqa.allocation;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * A robot as an allocator sees it.
 *
 * @param maxLoad kilograms
 * @param diameter metres
 * @param speed metres a second, straight on
 * @param position metres, map frame
 * @param parking its parking point, metres, map frame; where it stands if it has none
 * @param battery 0 to 1; null where it is not known
 * @param task what it works for; null while {@code standing} is not {@link Standing#BUSY}
 */
public record Candidate(
    String robot,
    double maxLoad,
    double diameter,
    double speed,
    Vec2 position,
    Vec2 parking,
    @Nullable Double battery,
    Standing standing,
    @Nullable Long task) {

  Candidate busyWith(long job) {
    return new Candidate(
        robot, maxLoad, diameter, speed, position, parking, battery, Standing.BUSY, job);
  }

  boolean isFree() {
    return standing == Standing.FREE;
  }

  boolean isStrongEnough(Job job) {
    return maxLoad >= job.load();
  }
}
