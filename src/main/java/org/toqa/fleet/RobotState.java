package org.toqa.fleet;

import org.toqa.allocation.Availability;

/** What the server knows of a robot at this moment; {@link RobotCondition} tells how. */
public enum RobotState {
  /** Never heard of since the server started. */
  CONNECTING(Kind.UNREACHABLE, Availability.CONNECTING),
  /** At its parking point or waiting, free for a task. */
  IDLE(Kind.OPERATIONAL, Availability.FREE),
  DRIVING(Kind.OPERATIONAL, Availability.FREE),
  /** Is at a charging point and charges. */
  CHARGING(Kind.CHARGING, Availability.CHARGING),
  /** Is stopped in the middle of its path. */
  HOLDING(Kind.OPERATIONAL, Availability.HELD),
  /** Does not know where it is; a person must say it. */
  NOT_LOCALISED(Kind.TROUBLED, Availability.NOT_LOCALISED),
  ERROR(Kind.TROUBLED, Availability.ERROR),
  /** Silent for more than two seconds. */
  LOST(Kind.UNREACHABLE, Availability.LOST),
  /** A person has taken it out of service: it gets no task and is not told to drive. */
  OUT_OF_SERVICE(Kind.OUT_OF_SERVICE, Availability.OUT_OF_SERVICE);

  private final Kind kind;
  private final Availability withoutTask;

  /** What states have in common. */
  public enum Kind {
    /** It drives, or could. */
    OPERATIONAL,
    /** It could work, but its battery comes first. */
    CHARGING,
    /** It is heard, but cannot go on without a person. */
    TROUBLED,
    UNREACHABLE,
    OUT_OF_SERVICE
  }

  RobotState(Kind kind, Availability withoutTask) {
    this.kind = kind;
    this.withoutTask = withoutTask;
  }

  public Kind kind() {
    return kind;
  }

  /** Whether the robot is in service, heard, knows where it is, and is well. */
  public boolean isFit() {
    return kind == Kind.OPERATIONAL || kind == Kind.CHARGING;
  }

  /** Whether a robot in this state that has no task could be given one, or what keeps it. */
  Availability withoutTask() {
    return withoutTask;
  }
}
