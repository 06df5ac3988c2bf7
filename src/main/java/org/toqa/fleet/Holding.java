package org.toqa.fleet;

import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.mission.Mission;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Lets robots hold that shall stand where they are, and go on when nothing keeps them. */
final class Holding {
  private static final Duration TOLD_AGAIN_AFTER = Duration.ofSeconds(1);
  private static final Duration STARTS_WITHIN = Duration.ofSeconds(30);

  private final FloorState state;
  private @Nullable Hold pause;

  Holding(FloorState state, @Nullable Hold pause) {
    this.state = state;
    this.pause = pause;
  }

  void pause(@Nullable Hold next) {
    pause = next;
    lookAgain();
  }

  void holdFloor(@Nullable Hold next) {
    state.hold = next;
    lookAgain();
  }

  private void lookAgain() {
    state.changed = true;
    state.robots.values().forEach(this::holdOrGoOn);
  }

  /** Tells the robot to hold or to go on, until it says that it does. */
  void holdOrGoOn(FloorRobot robot) {
    Sentence reason = reason(robot);
    state.changed |= !Objects.equals(reason, robot.holdReason);
    robot.holdReason = reason;
    boolean shall = reason != null;
    if (shall) {
      robot.lastHeld = state.now;
    }
    boolean does = robot.mode == Mode.ERROR ? robot.toldToHold : robot.mode == Mode.HOLDING;
    boolean isToldAlready =
        robot.toldToHold == shall && robot.toldToHoldAt.plus(TOLD_AGAIN_AFTER).isAfter(state.now);
    if (robot.isHeard() && shall != does && !isToldAlready) {
      robot.toldToHold = shall;
      robot.toldToHoldAt = state.now;
      robot.agent.tell(new RobotMessage.Hold(shall));
    }
  }

  private @Nullable Sentence reason(FloorRobot robot) {
    if (pause != null) {
      return Phrase.ALL_PAUSED_BY.with(pause.user());
    }
    if (state.hold != null) {
      return Phrase.FLOOR_HELD_BY.with(state.floor.name(), state.hold.user());
    }
    if (robot.held) {
      return Phrase.HELD_BY_A_PERSON.with();
    }
    return state.missions.of(robot.name()).map(this::reason).orElse(null);
  }

  private @Nullable Sentence reason(Mission mission) {
    return mission.held()
        ? Phrase.TASK_ON_HOLD.with(mission.id())
        : state.formations.reasonToStand(mission);
  }

  /** A robot on hold does not get on, and needs a while when it goes on. */
  boolean isHeldLately(String name) {
    FloorRobot robot = state.robots.get(name);
    return robot != null && robot.lastHeld.plus(STARTS_WITHIN).isAfter(state.now);
  }
}
