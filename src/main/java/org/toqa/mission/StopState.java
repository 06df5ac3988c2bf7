package org.toqa.mission;

/** What a stop is to a mission now. */
public enum StopState {
  /** Its robots were there. */
  PASSED,
  /** They wait there. */
  HERE,
  /** They drive there. */
  NEXT,
  AHEAD
}
