package org.toqa.fleet;

import java.time.Duration;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.mission.Mission;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Sends robots that have nothing to do to their parking points. */
final class Homing {
  /** A robot that is needed again at once need not turn round. */
  private static final Duration HOME_AFTER = Duration.ofSeconds(3);

  private final FloorState state;

  Homing(FloorState state) {
    this.state = state;
  }

  void sendHome(FloorRobot robot) {
    state.home(robot.name()).ifPresent(parking -> robot.errand = Errand.home(parking));
  }

  /** Why a person cannot send the robot home now; null if it can be. */
  @Nullable Sentence objection(FloorRobot robot) {
    Optional<Mission> mission = state.missions.of(robot.name());
    if (mission.isPresent()) {
      return Phrase.HOME_AFTER_TASK.with(robot.name(), mission.get().id());
    }
    if (robot.turn != null) {
      return Phrase.HOME_AFTER_CHARGING.with(robot.name());
    }
    if (state.home(robot.name()).isEmpty()) {
      return Phrase.HAS_NO_HOME.with(robot.name());
    }
    if (robot.holdReason != null) {
      return Phrase.LET_IT_GO_ON_FIRST.with(robot.name());
    }
    return robot.isFit() ? null : Phrase.CANNOT_DRIVE_NOW.with(robot.name());
  }

  /** Parking when idle. */
  void sendHomeWhenIdle(FloorRobot robot) {
    boolean isIdle =
        robot.errand == null
            && robot.isStanding()
            && robot.isFit()
            && robot.holdReason == null
            && state.missions.of(robot.name()).isEmpty();
    if (!isIdle) {
      robot.idleSince = null;
    } else if (robot.idleSince == null) {
      robot.idleSince = state.now;
    } else if (!robot.idleSince.plus(HOME_AFTER).isAfter(state.now)) {
      state
          .home(robot.name())
          .filter(parking -> !state.isAt(robot, parking))
          .ifPresent(parking -> robot.errand = Errand.home(parking));
    }
  }
}
