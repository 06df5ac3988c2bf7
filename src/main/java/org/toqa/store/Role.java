package org.toqa.store;

/** What a user may do. */
public enum Role {
  /** Sees everything, adds tasks and changes his own. */
  CLERK,
  /** May do everything. */
  MANAGER
}
