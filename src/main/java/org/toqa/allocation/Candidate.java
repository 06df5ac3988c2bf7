package org.toqa.allocation;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * A robot as an allocator sees it.
 *
 * @param maxLoad kilograms
 * @param diameter metres
 * @param speed metres a second, straight on
 * @param isOmnidirectional whether it can go sideways, so that a group with it takes tight corners
 * @param position metres, map frame
 * @param parking its parking point, metres, map frame; where it is if it has none
 * @param battery 0 to 1; null where it is not known
 * @param task what it works for; null while {@code availability} is not {@link Availability#BUSY}
 * @param canBeInTeam whether it can carry a load together with others
 * @param knowsShifts whether a group with it may be led sideways, if all of it can
 */
public record Candidate(
    String robot,
    double maxLoad,
    double diameter,
    double speed,
    boolean isOmnidirectional,
    Vec2 position,
    Vec2 parking,
    @Nullable Double battery,
    Availability availability,
    @Nullable Long task,
    boolean canBeInTeam,
    boolean knowsShifts) {

  /** Of one that can carry a load together with others. */
  public Candidate(
      String robot,
      double maxLoad,
      double diameter,
      double speed,
      boolean isOmnidirectional,
      Vec2 position,
      Vec2 parking,
      @Nullable Double battery,
      Availability availability,
      @Nullable Long task) {
    this(
        robot,
        maxLoad,
        diameter,
        speed,
        isOmnidirectional,
        position,
        parking,
        battery,
        availability,
        task,
        true);
  }

  /** Of one with which no group is led sideways. */
  public Candidate(
      String robot,
      double maxLoad,
      double diameter,
      double speed,
      boolean isOmnidirectional,
      Vec2 position,
      Vec2 parking,
      @Nullable Double battery,
      Availability availability,
      @Nullable Long task,
      boolean canBeInTeam) {
    this(
        robot,
        maxLoad,
        diameter,
        speed,
        isOmnidirectional,
        position,
        parking,
        battery,
        availability,
        task,
        canBeInTeam,
        false);
  }

  Candidate withTask(long task) {
    return with(Availability.BUSY, task);
  }

  Candidate withoutTask() {
    return with(Availability.FREE, null);
  }

  private Candidate with(Availability next, @Nullable Long nextTask) {
    return new Candidate(
        robot,
        maxLoad,
        diameter,
        speed,
        isOmnidirectional,
        position,
        parking,
        battery,
        next,
        nextTask,
        canBeInTeam,
        knowsShifts);
  }

  boolean isFree() {
    return availability == Availability.FREE;
  }

  boolean isStrongEnough(AllocationTask task) {
    return maxLoad >= task.load() && task.allows(robot);
  }
}
