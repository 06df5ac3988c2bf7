package org.toqa.fleet;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * One line of the history.
 *
 * @param kind a word for programs, such as {@code task.carrying}
 * @param task the task it concerns, if any
 * @param robot the robot it concerns, if any
 * @param who a user's name, or {@code toqa}
 * @param text a sentence for people
 */
public record EventRecord(
    Instant at, String kind, @Nullable Long task, @Nullable String robot, String who, String text) {

  /** Who acts when no person does. */
  public static final String SYSTEM = "toqa";
}
