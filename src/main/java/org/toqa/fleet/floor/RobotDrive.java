package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/**
 * Where a robot shall drive, and what it was told of that: the floor acts where they differ. All
 * changes are the methods of this class.
 */
final class RobotDrive {
  private @Nullable DriveGoal goal;
  private DriveOrder order = new DriveOrder.None();
  private Instant notBefore = Instant.MIN;
  private @Nullable Sentence waitReason;
  private long lastNumber;
  private @Nullable Pose storedPlace;

  // --- where it shall drive ---------------------------------------------------------------------

  /** Null: nowhere. */
  @Nullable DriveGoal goal() {
    return goal;
  }

  void setGoal(DriveGoal next) {
    goal = next;
  }

  /** It shall drive there at once. */
  void setGoalNow(DriveGoal next) {
    goal = next;
    waitReason = null;
    notBefore = Instant.MIN;
  }

  /** It has nothing to drive for the task any more. */
  void dropGoal(long task) {
    if (goal != null && Objects.equals(goal.task(), task)) {
      goal = null;
      waitReason = null;
    }
  }

  /** It has nothing to drive any more, unless that is for a task. */
  void dropGoalWithoutTask() {
    if (goal != null && goal.task() == null) {
      goal = null;
    }
  }

  /** Why it does not get on; null: it does, or nobody knows. */
  @Nullable Sentence waitReason() {
    return waitReason;
  }

  /**
   * @return whether that is new
   */
  boolean setWaitReason(@Nullable Sentence reason) {
    boolean isNew = !Objects.equals(waitReason, reason);
    waitReason = reason;
    return isNew;
  }

  boolean isPostponed(Instant now) {
    return notBefore.isAfter(now);
  }

  // --- where it stopped
  // ---------------------------------------------------------------------------

  /** The number of the last drive that is known of, 0 without one. */
  long lastNumber() {
    return lastNumber;
  }

  /** Where it stood when that was last stored, map frame; null: that is not known any more. */
  @Nullable Pose storedPlace() {
    return storedPlace;
  }

  /**
   * @param pose null: it is to be stored again
   */
  void setStoredPlace(@Nullable Pose pose) {
    storedPlace = pose;
  }

  // --- what it was told -------------------------------------------------------------------------

  DriveOrder order() {
    return order;
  }

  /** Whether it was told to end its drive. */
  boolean isCancelling() {
    return order instanceof DriveOrder.Cancelling;
  }

  /** It is being told a drive. */
  void setTold(@Nullable Vec2 leadsTo) {
    order = new DriveOrder.Told(Optional.empty(), leadsTo);
  }

  /** The drive that it is being told has its number. */
  void setBegun(StoredDrive drive) {
    order = order.begun(drive);
    lastNumber = drive.seq();
    storedPlace = null;
  }

  /**
   * It is connected anew.
   *
   * @param drive the one that it has, if it is known here
   * @param newLastNumber of the last drive that was stored for it
   */
  void reconnect(Optional<StoredDrive> drive, long newLastNumber) {
    lastNumber = newLastNumber;
    Vec2 leadsTo = order.knownGoal();
    order =
        drive
            .<DriveOrder>map(d -> new DriveOrder.Driving(d, leadsTo))
            .orElse(new DriveOrder.None());
  }

  /** It has taken the drive, or never will. */
  void settle() {
    order = order.settled();
  }

  /**
   * It says that it has taken a drive.
   *
   * @param number of the drive; 0: it has none
   * @return whether that is the one that it was told
   */
  boolean settle(long number) {
    boolean isTold = order.isOf(number);
    if (isTold) {
      settle();
    }
    return isTold;
  }

  /** It has refused what it was told, and shall not be told anew before a time. */
  void abandonCommand(Instant until, Sentence why) {
    settle();
    endCancelling();
    notBefore = until;
    waitReason = why;
  }

  void cancel() {
    order = order.cancelled();
  }

  /** What was to end has ended, or goes on. */
  void endCancelling() {
    order = order.uncancelled();
  }

  /** It has no drive any more. */
  void end() {
    order = new DriveOrder.None();
  }
}
