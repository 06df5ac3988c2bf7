package org.toqa.fleet.floor;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.geometry.Vec2;

/**
 * What a robot was told to drive, until that is over: {@code None -> Told -> Driving -> None}, and
 * {@code Cancelling} from each of them.
 */
sealed interface DriveOrder {

  /** Nothing. */
  record None() implements DriveOrder {}

  /**
   * A drive that the robot has not taken yet.
   *
   * @param drive empty until the robot's agent has numbered it
   * @param goal as of {@link Driving}
   */
  record Told(Optional<StoredDrive> drive, @Nullable Vec2 goal) implements DriveOrder {}

  /**
   * A drive that the robot has taken.
   *
   * @param goal where it shall lead, metres, map frame; null where the robot only steps aside, and
   *     after a restart
   */
  record Driving(StoredDrive drive, @Nullable Vec2 goal) implements DriveOrder {}

  /**
   * The robot was told to end what it drives.
   *
   * @param order what that is; None where the robot has a drive that nobody here knows
   */
  record Cancelling(DriveOrder order) implements DriveOrder {
    public Cancelling {
      if (order instanceof Cancelling) {
        throw new IllegalArgumentException("cancelled already");
      }
    }
  }

  /** The drive, if there is one and it has its number. */
  default Optional<StoredDrive> storedDrive() {
    return switch (this) {
      case None ignored -> Optional.empty();
      case Told told -> told.drive();
      case Driving driving -> Optional.of(driving.drive());
      case Cancelling cancelling -> cancelling.order().storedDrive();
    };
  }

  /** Where it shall lead, metres, map frame; null where that is not known. */
  default @Nullable Vec2 knownGoal() {
    return switch (this) {
      case None ignored -> null;
      case Told told -> told.goal();
      case Driving driving -> driving.goal();
      case Cancelling cancelling -> cancelling.order().knownGoal();
    };
  }

  /** Whether the robot has not said yet that it takes the drive. */
  default boolean isPending() {
    return switch (this) {
      case None ignored -> false;
      case Told ignored -> true;
      case Driving ignored -> false;
      case Cancelling cancelling -> cancelling.order().isPending();
    };
  }

  /** Whether this is the drive of that number, which is not 0. */
  default boolean isOf(long number) {
    return storedDrive().filter(drive -> drive.seq() == number).isPresent();
  }

  /** The robot's agent has numbered the drive. */
  default DriveOrder begun(StoredDrive drive) {
    return switch (this) {
      case None ignored -> new Driving(drive, null);
      case Told told -> new Told(Optional.of(drive), told.goal());
      case Driving driving -> new Driving(drive, driving.goal());
      case Cancelling cancelling -> new Cancelling(cancelling.order().begun(drive));
    };
  }

  /** Nothing is awaited of the robot any more: it has taken the drive, or there is none. */
  default DriveOrder settled() {
    return switch (this) {
      case None ignored -> this;
      case Told told ->
          told.drive().<DriveOrder>map(drive -> new Driving(drive, told.goal())).orElse(new None());
      case Driving ignored -> this;
      case Cancelling cancelling -> new Cancelling(cancelling.order().settled());
    };
  }

  /** What it was before it was cancelled. */
  default DriveOrder uncancelled() {
    return this instanceof Cancelling(DriveOrder order) ? order : this;
  }

  default DriveOrder cancelled() {
    return this instanceof Cancelling ? this : new Cancelling(this);
  }
}
