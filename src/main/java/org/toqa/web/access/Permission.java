package org.toqa.web.access;

/** Who may use a route. */
public enum Permission {
  /** Also strangers, and before the first manager exists. */
  PUBLIC,
  /** Strangers, once there is a manager. */
  ANONYMOUS,
  /** Every user who is logged in. */
  SIGNED_IN,
  MANAGER
}
