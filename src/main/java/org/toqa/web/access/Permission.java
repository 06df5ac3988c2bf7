package org.toqa.web.access;

/** Who may use a route. */
public enum Permission {
  /** Everybody, also who is not signed in. */
  ANONYMOUS,
  /** Everybody who is signed in, whatever the account's role. */
  SIGNED_IN,
  /** Clerks, and managers. */
  CLERK,
  MANAGER
}
