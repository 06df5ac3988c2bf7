package org.toqa.fleet;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.mission.Mission;

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
  @Nullable String objection(FloorRobot robot) {
    Optional<Mission> mission = state.missions.of(robot.name());
    if (mission.isPresent()) {
      return robot.name() + " works for task " + mission.get().id() + "; it drives home after it.";
    }
    if (robot.turn != null) {
      return robot.name() + " must charge first; it drives home after it.";
    }
    if (state.home(robot.name()).isEmpty()) {
      return robot.name() + " has no parking point, so it has no home.";
    }
    if (robot.holdReason != null) {
      return robot.name() + " is on hold; let it go on first.";
    }
    return robot.isFit()
        ? null
        : robot.name()
            + " cannot drive now: it is "
            + robot.state().name().toLowerCase(Locale.ROOT).replace('_', ' ')
            + ".";
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
