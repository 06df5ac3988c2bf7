package org.toqa.store;

import org.toqa.accounts.Account;
import org.toqa.accounts.SessionStore.AuthenticatedSession;

/**
 * Who was logged in, for the time in which the database does not answer: he goes on to see the
 * robots and can stop them. Nobody does whose login was ended before, or who was changed.
 */
public final class LastKnownUsers {
  final FallbackCache<String, AuthenticatedSession> sessions = new FallbackCache<>();
  final FallbackCache<Long, Account> accounts = new FallbackCache<>();

  /** After something of that user has ended or was changed: it is read from the database again. */
  void forget(long user) {
    sessions.forgetAll(login -> login.account().id() == user);
    accounts.forget(user);
  }
}
