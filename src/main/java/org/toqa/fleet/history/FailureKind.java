package org.toqa.fleet.history;

import java.util.stream.Stream;

/** What goes wrong, as the history tells it. */
public enum FailureKind {
  /** A robot that had a task reported an error, or was not heard of for too long. */
  ROBOT_FAILED("task.robot-failed"),
  /** A robot that had a task was not heard of for a few seconds. */
  ROBOT_LOST("task.robot-lost"),
  ROBOT_WITHDRAWN("task.robot-withdrawn"),
  /** A robot had to charge before it had fetched the load, and gave the task back. */
  ROBOT_CHARGES("task.robot-charges"),
  /** A deadline could not be met any more. */
  LATE("task.late"),
  /** Robots stood before each other. */
  STANDSTILL("traffic.standstill"),
  CHARGER_FAILS("robot.charger-fails");

  private final String kind;

  FailureKind(String kind) {
    this.kind = kind;
  }

  /** The kind of its events. */
  public String kind() {
    return kind;
  }

  public static FailureKind of(String kind) {
    return Stream.of(values())
        .filter(failure -> failure.kind.equals(kind))
        .findFirst()
        .orElseThrow();
  }
}
