package org.toqa.mission;

import java.util.Arrays;
import java.util.Optional;

/** What a person can answer when a robot of a task is in trouble. */
public enum Reply {
  /** Another robot takes the task, and fetches the load from where it is. */
  ANOTHER("another robot"),
  /** The task waits until the robot can go on. */
  WAIT("wait"),
  /** The arm tries what it failed to do once more. */
  AGAIN("try again"),
  /** A person has done by hand what the arm failed to do. */
  BY_HAND("done by hand"),
  /** The task ends; a load that is on board stays where it is. */
  CANCEL("cancel");

  private final String word;

  Reply(String word) {
    this.word = word;
  }

  /** As people and programs write it. */
  public String word() {
    return word;
  }

  public static Optional<Reply> ofWord(String word) {
    return Arrays.stream(values()).filter(r -> r.word.equals(word)).findFirst();
  }
}
