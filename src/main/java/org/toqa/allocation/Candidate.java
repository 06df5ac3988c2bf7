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
 * @param parking its parking point, metres, map frame; where it is if it has none
 * @param battery 0 to 1; null where it is not known
 * @param task what it works for; null while {@code availability} is not {@link Availability#BUSY}
 */
public record Candidate(
    String robot,
    double maxLoad,
    double diameter,
    double speed,
    Vec2 position,
    Vec2 parking,
    @Nullable Double battery,
    Availability availability,
    @Nullable Long task) {

  Candidate withTask(long task) {
    return new Candidate(
        robot, maxLoad, diameter, speed, position, parking, battery, Availability.BUSY, task);
  }

  Candidate withoutTask() {
    return new Candidate(
        robot, maxLoad, diameter, speed, position, parking, battery, Availability.FREE, null);
  }

  boolean isFree() {
    return availability == Availability.FREE;
  }

  boolean isStrongEnough(AllocationTask task) {
    return maxLoad >= task.load();
  }
}
