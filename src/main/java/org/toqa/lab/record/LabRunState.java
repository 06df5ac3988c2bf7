package org.toqa.lab.record;

/** How far a run is. */
public enum LabRunState {
  /** Waits until the runs before it are over. */
  QUEUED,
  RUNNING,
  /** There is a report. */
  DONE,
  /** By a person, before its end. */
  STOPPED,
  /** It could not be done; its detail says why. */
  FAILED,
  /** The server ended while it ran. */
  BROKEN_OFF;

  public boolean isOver() {
    return this != QUEUED && this != RUNNING;
  }
}
