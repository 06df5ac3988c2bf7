package org.toqa.web.input;

import java.util.concurrent.CompletionStage;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.RobotView;

/** A command that a manager may give a robot. */
@FunctionalInterface
public interface RobotCommand {
  /**
   * @param robot the robot's name
   * @param user the manager's name
   */
  CompletionStage<Answer<RobotView>> send(Fleet fleet, String robot, String user);

  /**
   * One that says how.
   *
   * @param <T> what it says
   */
  @FunctionalInterface
  interface With<T> {
    CompletionStage<Answer<RobotView>> send(Fleet fleet, String robot, T value, String user);

    /** The command with that value. */
    default RobotCommand of(T value) {
      return (fleet, robot, user) -> send(fleet, robot, value, user);
    }
  }
}
