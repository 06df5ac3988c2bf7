package org.toqa.fleet;

/** What the server knows of a robot at this moment. */
public enum RobotState {
  /** Never heard of since the server started. */
  CONNECTING,
  /** At its parking point or waiting, free for a task. */
  IDLE,
  DRIVING,
  /** Stands at a charging point and charges. */
  CHARGING,
  /** Stands in the middle of its way. */
  HOLDING,
  /** Does not know where it is; a person must say it. */
  NOT_LOCALISED,
  ERROR,
  /** Silent for more than two seconds. */
  LOST,
  /** A person has taken it out of service: it gets no task and is not told to drive. */
  OUT_OF_SERVICE
}
