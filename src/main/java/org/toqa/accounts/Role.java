package org.toqa.accounts;

/** What a user may do. */
public enum Role {
  /** Sees everything, adds tasks and changes his own. */
  CLERK,
  /** May do everything. */
  MANAGER
}
