package org.toqa.fleet.history;

import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;

/** What a robot spends its time with. */
public enum RobotActivity {
  /** Fetches a load or carries it, also while it makes room for others. */
  WORKING,
  /** Drives without a load to fetch or carry: home, to a charging point, to make room. */
  TRAVELLING,
  CHARGING,
  /** Is stopped, and could be given a task. */
  IDLE,
  /** An operator put it on hold: by itself, with its task, its floor or the whole fleet. */
  HELD,
  /** Reports an error, or does not know where it is. */
  TROUBLED,
  /** Is not heard of. */
  LOST,
  OUT_OF_SERVICE;

  static RobotActivity of(RobotView robot) {
    return switch (robot.state().kind()) {
      case OUT_OF_SERVICE -> OUT_OF_SERVICE;
      case UNREACHABLE -> LOST;
      case TROUBLED -> TROUBLED;
      case CHARGING -> CHARGING;
      case OPERATIONAL -> ofOperational(robot);
    };
  }

  private static RobotActivity ofOperational(RobotView robot) {
    if (robot.work().held()) {
      return HELD;
    }
    if (robot.work().phase().isCarryingTask()) {
      return WORKING;
    }
    return robot.state() == RobotState.IDLE ? IDLE : TRAVELLING;
  }
}
