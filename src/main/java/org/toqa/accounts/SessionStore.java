package org.toqa.accounts;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Who is signed in, from where, and by which secret. Sessions outlive the server's process.
 *
 * <p>Any thread may call it and may have to wait. Every method throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer.
 */
public interface SessionStore {
  /** A session and the secret that is shown for it, which is told but once. */
  record NewSession(Session session, String secret) {
    /** Without the secret, so that it reaches no log. */
    @Override
    public String toString() {
      return "NewSession[" + session + "]";
    }
  }

  /** A session and its user. */
  record AuthenticatedSession(Account account, Session session) {}

  /**
   * Begins a session of somebody who has logged in. Expired sessions of all users are removed with
   * it; and of that user's of its kind, where they are more than he may have, the one that was not
   * used for longest.
   *
   * @param kind not {@code TOKEN}
   */
  NewSession begin(Account account, Session.Kind kind, Session.Origin origin);

  /**
   * A token for a program of that user, which is told in the history.
   *
   * @param name what its owner calls it
   * @param scopes what it may do of what its user may
   * @param lifetime how long it is valid from now on, in real time
   */
  NewSession issueToken(
      Account account, String name, Set<Scope> scopes, Session.Origin origin, Duration lifetime);

  /** Whether that account has fewer tokens than it may have. */
  boolean mayIssueToken(long accountId);

  /**
   * Whose secret it is, while it is good; what was read last while the store does not answer. It
   * counts as use of the session, which puts off its end, but never beyond the time at which a
   * session ends for good.
   */
  Optional<AuthenticatedSession> authenticate(Session.Carrier carrier, String secret);

  /** The same for what nobody asked for himself, such as a page that stays open: it is no use. */
  Optional<AuthenticatedSession> find(Session.Carrier carrier, String secret);

  /** Of that account, the newest first. */
  List<Session> sessions(long accountId);

  /**
   * Ends a session of that account.
   *
   * @param by who ends it
   * @return false when that account has no such session
   */
  boolean end(Account account, long sessionId, String by);

  /** The holder of the secret signs out. */
  void end(String secret);
}
