package org.toqa.arm;

/** A part of what an arm does. */
public enum ArmStep {
  /** Its hand moves to the place. */
  REACH,
  /** Its hand closes. */
  GRASP,
  /** Its load sensor tells what hangs on it. */
  WEIGH,
  /** Its hand opens. */
  RELEASE,
  /** Its joints turn to their rest. */
  FOLD
}
