package org.toqa.forecast;

/** Why it cannot be said when a task is picked up or delivered. */
public enum Unknown {
  /** It, or what carries it, is on hold. */
  ON_HOLD,
  /** A person has to decide something first. */
  NEEDS_DECISION,
  /** It waits at a stop until a person says that it may go on. */
  AWAITS_PERSON,
  /** No robot that may carry it can be expected to be free. */
  NO_ROBOT,
  /** No path to its places is known. */
  NO_PATH,
  /** It begins after a task of which no time can be said. */
  AFTER_UNKNOWN,
  /** So many tasks come before it that nobody looks that far. */
  FAR_BACK
}
