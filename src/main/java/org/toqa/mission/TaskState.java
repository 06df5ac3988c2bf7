package org.toqa.mission;

/** A transport task's life, in order; the last three are its ends. */
public enum TaskState {
  /** Stored; no robot has it yet. */
  QUEUED,
  /** Robots are chosen; none has moved for it yet. */
  ASSIGNED,
  /** Phase 1: the robots drive to the object; of a drive without a load all of it. */
  TO_OBJECT,
  /** Phase 2: the load is carried to its goal. */
  CARRYING,
  /** Phase 3: the load is delivered, or the drive has ended, and the robots drive home. */
  RETURNING,
  DONE,
  FAILED,
  CANCELLED;

  /** Whether robots were chosen, and work for it or have done so to its end. */
  public boolean isAssigned() {
    return this == ASSIGNED || this == TO_OBJECT || this == CARRYING || isDelivered();
  }

  public boolean isDelivered() {
    return this == RETURNING || this == DONE;
  }

  public boolean isEnded() {
    return this == DONE || this == FAILED || this == CANCELLED;
  }
}
