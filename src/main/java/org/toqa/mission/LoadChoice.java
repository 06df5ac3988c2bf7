package org.toqa.mission;

/** What becomes of a load that is on board when its task is cancelled. */
public enum LoadChoice {
  /** It is set down where the robot stops. */
  HERE,
  /** It is carried back to where it was fetched first. */
  BACK
}
