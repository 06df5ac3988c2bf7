package org.toqa.fleet.floor;

import java.time.Duration;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.Mission;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Sends robots that have nothing to do to their parking points. */
final class HomeDispatcher {
  /** A robot that is needed again at once need not turn round. */
  private static final Duration HOME_AFTER = Duration.ofSeconds(3);

  private final FloorState state;

  HomeDispatcher(FloorState state) {
    this.state = state;
  }

  void sendHome(FloorRobot robot) {
    state
        .parkingPoint(robot.name())
        .ifPresent(parking -> robot.drive.setGoal(DriveGoal.toParking(parking)));
  }

  /** Why a person cannot send the robot home now; null if it can be. */
  @Nullable Sentence objection(FloorRobot robot) {
    Sentence busy = objectionToLeave(robot);
    return busy == null && state.parkingPoint(robot.name()).isEmpty()
        ? Phrase.HAS_NO_HOME.with(robot.name())
        : busy;
  }

  /** Why the robot cannot be sent anywhere now; null if it can be. */
  @Nullable Sentence objectionToLeave(FloorRobot robot) {
    Optional<Mission> mission = state.missions.missionOf(robot.name());
    if (mission.isPresent()) {
      return Phrase.HOME_AFTER_TASK.with(robot.name(), mission.get().id());
    }
    if (robot.charging.hasTurn()) {
      return Phrase.HOME_AFTER_CHARGING.with(robot.name());
    }
    String driver = robot.manual.driver();
    if (driver != null) {
      return Phrase.DRIVEN_BY_ANOTHER.with(robot.name(), driver);
    }
    if (robot.hold.isHeld()) {
      return robot.settings.isHeld()
          ? Phrase.LET_IT_GO_ON_FIRST.with(robot.name())
          : robot.hold.reason();
    }
    return robot.isFit() ? null : Phrase.CANNOT_DRIVE_NOW.with(robot.name());
  }

  /** Parking when idle. */
  void sendIdleHome(FloorRobot robot) {
    boolean isIdle =
        robot.drive.goal() == null
            && robot.isStanding()
            && robot.isFit()
            && !robot.hold.isHeld()
            && !robot.manual.isActive()
            && state.missions.missionOf(robot.name()).isEmpty();
    if (robot.idle.update(isIdle, HOME_AFTER, state.now)) {
      state
          .parkingPoint(robot.name())
          .filter(parking -> !state.isAt(robot, parking))
          .ifPresent(parking -> robot.drive.setGoal(DriveGoal.toParking(parking)));
    }
  }
}
