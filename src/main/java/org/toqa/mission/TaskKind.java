package org.toqa.mission;

/** What a task is about. */
public enum TaskKind {
  /** A load is carried. */
  TRANSPORT,
  /** A robot drives somewhere without a load. */
  DRIVE
}
