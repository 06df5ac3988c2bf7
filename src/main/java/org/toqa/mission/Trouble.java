package org.toqa.mission;

import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What keeps a robot from going on with its mission.
 *
 * @param why a clause about the robot, such as {@code is not heard of}
 * @param place where the robot was last; null when nobody knows
 * @param isAwaited whether a person said that the mission waits for the robot
 * @param isOfArm whether it is well, but its arm did not do what it should
 */
public record Trouble(
    String robot, Sentence why, @Nullable TaskPlace place, boolean isAwaited, boolean isOfArm) {

  /** That the robot cannot go on. */
  public Trouble(String robot, Sentence why, @Nullable TaskPlace place, boolean isAwaited) {
    this(robot, why, place, isAwaited, false);
  }

  Trouble withWaiting() {
    return new Trouble(robot, why, place, true, isOfArm);
  }

  /**
   * @param now where the robot, or the load that it carries with others, is; null: where it was
   */
  Trouble withPlace(@Nullable TaskPlace now) {
    return now == null ? this : new Trouble(robot, why, now, isAwaited, isOfArm);
  }

  /** Which robot, and what. */
  Sentence sentence() {
    return Phrase.ROBOT_AND_CLAUSE.with(robot, why);
  }

  /** Whether it says the same, also where it was stored in other parts. */
  boolean isSameAs(Trouble other) {
    return isOfArm == other.isOfArm && sentence().english().equals(other.sentence().english());
  }
}
