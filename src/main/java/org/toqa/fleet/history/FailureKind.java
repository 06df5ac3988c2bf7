package org.toqa.fleet.history;

import java.util.stream.Stream;
import org.toqa.fleet.EventKind;

/** What goes wrong, as the history tells it. */
public enum FailureKind {
  /** A robot that had a task reported an error, or was not heard of for too long. */
  ROBOT_FAILED(EventKind.TASK_ROBOT_FAILED),
  /** A robot that had a task was not heard of for a few seconds. */
  ROBOT_LOST(EventKind.TASK_ROBOT_LOST),
  ROBOT_WITHDRAWN(EventKind.TASK_ROBOT_WITHDRAWN),
  /** A robot had to charge before it had fetched the load, and gave the task back. */
  ROBOT_CHARGES(EventKind.TASK_ROBOT_CHARGES),
  /** A deadline could not be met any more. */
  LATE(EventKind.TASK_LATE),
  /** Robots blocked each other. */
  STANDSTILL(EventKind.TRAFFIC_STANDSTILL),
  CHARGER_FAILS(EventKind.ROBOT_CHARGER_FAILS);

  private final EventKind kind;

  FailureKind(EventKind kind) {
    this.kind = kind;
  }

  /** The kind of its events, as it is stored. */
  public String kind() {
    return kind.text();
  }

  public static FailureKind of(String kind) {
    return Stream.of(values())
        .filter(failure -> failure.kind().equals(kind))
        .findFirst()
        .orElseThrow();
  }
}
