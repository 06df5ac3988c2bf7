package org.toqa.accounts;

/** What a user may do. */
public enum Role {
  /** Sees everything, adds tasks and changes his own. */
  CLERK,
  /** May do everything within the site. */
  MANAGER,
  /** A manager of the first site who also makes other sites, and sees them all. */
  ADMINISTRATOR;

  public boolean isManager() {
    return this != CLERK;
  }
}
