package org.toqa.traffic.lifelong;

/** What a robot may expect of the traffic. */
public enum PlanStatus {
  /** It is at its goal. */
  ARRIVED,
  /** It has a path, and drives or waits its turn. */
  DRIVING,
  /** The time did not suffice to look for its path; it keeps out of others' until the next plan. */
  NOT_YET_PLANNED,
  /** It is on a cell that may not be driven, and stays there. */
  START_BLOCKED,
  /** It does not move, short of its goal. */
  FIXED,
  /** Another robot of the snapshot is on the same cell; this one stays. */
  START_SHARED,
  /** Its goal may not be driven. */
  GOAL_BLOCKED,
  /** There is no path to its goal. */
  NO_PATH
}
