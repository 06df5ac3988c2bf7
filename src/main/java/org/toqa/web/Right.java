package org.toqa.web;

/** Who may pass a {@link Door}. */
public enum Right {
  /** Also strangers, and before the first manager exists. */
  ANYBODY,
  /** Strangers, once there is a manager. */
  STRANGER,
  /** Every user who is logged in. */
  USER,
  MANAGER
}
