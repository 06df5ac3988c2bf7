package org.toqa.fleet;

import org.toqa.allocation.Availability;
import org.toqa.link.message.AgentMessage.Mode;

/**
 * A robot's condition, derived in this one place: its state from what is known of it, and from the
 * state whether it can be given a task. What it spends its time with follows from {@link
 * RobotState.Kind}.
 *
 * @param inService as an operator set it
 * @param everHeard since the server started
 * @param heard now
 * @param localised whether it says that it knows where it is
 * @param mode as it says
 * @param leftOut since it does not do what it is told
 * @param charging whether it is at its charging point and is the first one there
 */
public record RobotCondition(
    boolean inService,
    boolean everHeard,
    boolean heard,
    boolean localised,
    Mode mode,
    boolean leftOut,
    boolean charging) {

  public RobotState state() {
    if (!inService) {
      return RobotState.OUT_OF_SERVICE;
    }
    if (!everHeard) {
      return RobotState.CONNECTING;
    }
    if (!heard) {
      return RobotState.LOST;
    }
    if (!localised) {
      return RobotState.NOT_LOCALISED;
    }
    if (leftOut) {
      return RobotState.ERROR;
    }
    return switch (mode) {
      case IDLE -> charging ? RobotState.CHARGING : RobotState.IDLE;
      case DRIVING, FOLLOWING -> RobotState.DRIVING;
      case HOLDING -> RobotState.HOLDING;
      case ERROR -> RobotState.ERROR;
    };
  }

  /**
   * Whether the robot can be given a task.
   *
   * @param isPromised whether it is being given one which its view does not tell of yet
   */
  public static Availability availability(RobotView robot, boolean isPromised) {
    Availability withoutTask = robot.state().withoutTask();
    return switch (withoutTask) {
      case FREE -> {
        if (robot.work().driver() != null) {
          yield Availability.DRIVEN_BY_HAND;
        }
        if (robot.work().charger() != null) {
          yield Availability.CHARGING;
        }
        yield isPromised || robot.work().phase().isCarryingTask()
            ? Availability.BUSY
            : Availability.FREE;
      }
      case HELD -> robot.work().task() == null ? Availability.HELD : Availability.BUSY;
      case BUSY, DRIVEN_BY_HAND, CHARGING, OUT_OF_SERVICE, LOST, CONNECTING, NOT_LOCALISED, ERROR ->
          withoutTask;
    };
  }
}
