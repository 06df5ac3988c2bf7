package org.toqa.mission;

import java.util.Optional;
import java.util.stream.Stream;

/** What a robot drives for (Tanta, "Task phases"). */
public enum Phase {
  /** No task: it is parked, drives home, or charges. */
  NONE(0),
  /** To where the load is fetched. */
  TO_OBJECT(1),
  /** With the load to where it is carried. */
  TO_GOAL(2),
  /** Home, or to where its next task begins. */
  HOME(3);

  private final int number;

  Phase(int number) {
    this.number = number;
  }

  /** As robots, the database and the API know it, 0 to 3. */
  public int number() {
    return number;
  }

  /** Whether the robot fetches a load or carries it: it is free for no other task. */
  public boolean isCarryingTask() {
    return this == TO_OBJECT || this == TO_GOAL;
  }

  /**
   * @return empty for a number that is not one of 0 to 3
   */
  public static Optional<Phase> of(int number) {
    return Stream.of(values()).filter(phase -> phase.number == number).findFirst();
  }

  /**
   * What was stored.
   *
   * @throws IllegalArgumentException if the number is not one of 0 to 3
   */
  public static Phase stored(int number) {
    return of(number)
        .orElseThrow(() -> new IllegalArgumentException("There is no phase " + number + "."));
  }
}
