package org.toqa.fleet.floor;

import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Hold;
import org.toqa.fleet.floor.HoldState.Instruction;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.mission.Mission;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Lets robots hold that shall stop where they are, and go on when nothing keeps them. */
final class HoldDispatcher {
  private static final Duration RESEND_AFTER = Duration.ofSeconds(1);
  private static final Duration STARTS_WITHIN = Duration.ofSeconds(30);

  private final FloorState state;
  private @Nullable Hold pause;

  HoldDispatcher(FloorState state, @Nullable Hold pause) {
    this.state = state;
    this.pause = pause;
  }

  void setPause(@Nullable Hold next) {
    pause = next;
    updateAll();
  }

  void setFloorHold(@Nullable Hold next) {
    state.hold = next;
    updateAll();
  }

  private void updateAll() {
    state.changed = true;
    state.robots.values().forEach(this::updateHold);
  }

  /** Tells the robot to hold or to go on, until it says that it does. */
  void updateHold(FloorRobot robot) {
    Sentence reason = holdReason(robot);
    state.changed |= robot.hold.setReason(reason, state.now);
    boolean shouldHold = reason != null;
    Instruction told = robot.hold.instruction();
    Mode mode = robot.reported.mode();
    boolean isHolding = mode == Mode.ERROR ? told.hold() : mode == Mode.HOLDING;
    boolean isToldAlready =
        told.hold() == shouldHold && told.at().plus(RESEND_AFTER).isAfter(state.now);
    if (robot.isHeard() && shouldHold != isHolding && !isToldAlready) {
      robot.hold.setInstruction(new Instruction(shouldHold, state.now));
      robot.agent.tell(new RobotMessage.Hold(shouldHold));
    }
  }

  /** A robot that is connected anew is told anew. */
  void robotConnected(FloorRobot robot) {
    robot.hold.setInstruction(Instruction.NONE);
    updateHold(robot);
  }

  private @Nullable Sentence holdReason(FloorRobot robot) {
    if (pause != null) {
      return pause.ofAll();
    }
    if (state.hold != null) {
      return state.hold.ofFloor(state.floor.name());
    }
    if (robot.settings.isHeld()) {
      return Phrase.HELD_BY_A_PERSON.with();
    }
    // a hold is obeyed before it is stored, and a resume after it
    Sentence asked = state.missions.missionOf(robot.name()).map(this::holdReason).orElse(null);
    return asked != null
        ? asked
        : state.missions.storedMissionOf(robot.name()).map(this::holdReason).orElse(null);
  }

  private @Nullable Sentence holdReason(Mission mission) {
    return mission.held()
        ? Phrase.TASK_ON_HOLD.with(mission.id())
        : state.formations.stopReason(mission);
  }

  /**
   * A robot on hold does not get on, and needs a while when it goes on; nor do those that carry a
   * load together with it.
   */
  boolean mayStand(String name) {
    return isRecentlyHeld(name)
        || state.formations.carryingMission(name).stream()
            .flatMap(mission -> mission.robots().stream())
            .anyMatch(this::isRecentlyHeld);
  }

  private boolean isRecentlyHeld(String name) {
    FloorRobot robot = state.robots.get(name);
    return robot != null && robot.hold.lastHeld().plus(STARTS_WITHIN).isAfter(state.now);
  }
}
