package org.toqa.formation;

/** Whether a leader may drive. */
public sealed interface Verdict {

  /**
   * @param pace above 0 and up to 1, as a share of the planned speed
   */
  record Drive(double pace) implements Verdict {}

  /**
   * @param follower the robot because of which the formation has stopped
   */
  record Stop(Reason reason, String follower) implements Verdict {}

  /** Why a formation has stopped. */
  enum Reason {
    /** It has not answered yet. */
    NOT_READY,
    /** It has missed two answers. */
    LATE,
    /** It says that it does not follow. */
    NOT_FOLLOWING,
    /** It is out of tolerance, and was not back near its place since. */
    OUT_OF_PLACE
  }
}
