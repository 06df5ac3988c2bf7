package org.toqa.mission;

import org.jspecify.annotations.Nullable;

/**
 * What keeps a robot from going on with its mission.
 *
 * @param why a clause about the robot, such as {@code is not heard of}
 * @param place where the robot was last; null when nobody knows
 * @param waits whether a person said that the mission waits for the robot
 */
public record Trouble(String robot, String why, @Nullable TaskPlace place, boolean waits) {

  Trouble waiting() {
    return new Trouble(robot, why, place, true);
  }

  /** For people: which robot, what, and where if that is known. */
  public String text() {
    return robot + " " + why;
  }
}
