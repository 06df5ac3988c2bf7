package org.toqa.fleet.history;

import java.util.stream.Stream;
import org.toqa.fleet.EventKind;

/** What interrupts work, as the history tells it: what goes wrong, and what was meant so. */
public enum FailureKind {
  /** A robot that had a task reported an error, or was not heard of for too long. */
  ROBOT_FAILED(EventKind.TASK_ROBOT_FAILED),
  /** A robot that had a task was not heard of for a few seconds. */
  ROBOT_LOST(EventKind.TASK_ROBOT_LOST),
  /** A person took a robot that had a task out of service. */
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

  /** Whether nothing has failed: a person wanted it so, or a battery was to be charged. */
  public boolean isPlanned() {
    return this == ROBOT_WITHDRAWN || this == ROBOT_CHARGES;
  }

  public static FailureKind of(String kind) {
    return Stream.of(values())
        .filter(failure -> failure.kind().equals(kind))
        .findFirst()
        .orElseThrow();
  }
}
