package org.toqa.web.access;

/** Who may use a route. */
public enum Permission {
  /** Everybody, also who is not signed in. */
  ANONYMOUS("problem.login"),
  /** Everybody who is signed in, whatever the account's role. */
  SIGNED_IN("problem.login"),
  /** Clerks, and managers. */
  CLERK("problem.managersOnly"),
  MANAGER("problem.managersOnly"),
  ADMINISTRATOR("problem.administratorsOnly");

  private final String refusalKey;

  /**
   * @param refusalKey of the sentence for a user who does not have it
   */
  Permission(String refusalKey) {
    this.refusalKey = refusalKey;
  }

  public String refusalKey() {
    return refusalKey;
  }
}
