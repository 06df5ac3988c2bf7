package org.toqa.mission;

import java.util.Arrays;
import java.util.Optional;

/** What a person can answer when a robot of a task is in trouble. */
public enum Reply {
  /** Another robot takes the task, and fetches the load from where it is. */
  ANOTHER("another robot"),
  /** The task waits until the robot can go on. */
  WAIT("wait"),
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
