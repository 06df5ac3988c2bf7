package org.toqa.store;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.mapper.Nested;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Session;
import org.toqa.accounts.Session.Kind;
import org.toqa.accounts.Session.Origin;
import org.toqa.accounts.SessionStore;
import org.toqa.fleet.EventKind;
import org.toqa.wording.Phrase;

/** Who is logged in, from where, and by which secret. They outlive the server's process. */
public final class JdbiSessionStore implements SessionStore {
  /** Of more sessions of one user only the newest are listed. */
  private static final int MAX_LISTED = 200;

  /** How exactly it is known when a session was last used. */
  private static final Duration SEEN_RESOLUTION = Duration.ofMinutes(1);

  private static final String COLUMNS =
      "s.id as session_id, s.user_id as session_user_id, s.kind as session_kind,"
          + " s.name as session_name, s.address as session_address, s.agent as session_agent,"
          + " s.created_at as session_created_at, s.seen_at as session_seen_at,"
          + " s.expires_at as session_expires_at";

  private final SqlExecutor sql;
  private final InstantSource clock;
  private final FallbackCache<String, AuthenticatedSession> lastKnown = new FallbackCache<>();

  public JdbiSessionStore(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  @Override
  public NewSession begin(Account user, Kind kind, Origin origin) {
    return sql.inTransaction(handle -> insert(handle, user, kind, null, origin, LIFETIME));
  }

  @Override
  public NewSession issueToken(Account user, String name, Origin origin, Duration life) {
    return sql.inTransaction(
        handle -> {
          EventTable.addAccountEvent(
              handle,
              clock.instant(),
              EventKind.USER_TOKEN,
              user.name(),
              Phrase.TOKEN_MADE.with(user.name(), name));
          return insert(handle, user, Kind.TOKEN, name, origin, life);
        });
  }

  @Override
  public Optional<AuthenticatedSession> authenticate(Kind kind, String secret) {
    String hash = Secret.hash(secret);
    return lastKnown.get(
        kind + hash, () -> sql.withHandle(handle -> findAndTouch(handle, kind, hash)));
  }

  @Override
  public List<Session> sessions(long userId) {
    return sql.withHandle(
        handle ->
            handle
                .createQuery(
                    "select "
                        + COLUMNS
                        + """
                           from sessions s where s.user_id = :user and s.expires_at > :now
                          order by s.seen_at desc, s.id desc limit
                          """
                        + MAX_LISTED)
                .bind("user", userId)
                .bind("now", clock.instant())
                .mapTo(ListedSessionRow.class)
                .map(row -> row.session().toSession())
                .list());
  }

  @Override
  public boolean end(Account user, long id, String by) {
    return sql.inTransaction(
        handle -> {
          boolean ended =
              handle.execute("delete from sessions where id = ? and user_id = ?", id, user.id())
                  > 0;
          if (ended) {
            EventTable.addAccountEvent(
                handle,
                clock.instant(),
                EventKind.USER_SESSION,
                by,
                Phrase.SESSION_ENDED.with(by, user.name()));
          }
          return ended;
        });
  }

  @Override
  public void end(String secret) {
    sql.withHandle(
        handle ->
            handle.execute("delete from sessions where secret_hash = ?", Secret.hash(secret)));
  }

  private Optional<AuthenticatedSession> findAndTouch(Handle handle, Kind kind, String hash) {
    Instant now = clock.instant();
    Optional<AuthenticatedSession> login =
        handle
            .createQuery(
                "select "
                    + AccountTable.COLUMNS
                    + ", "
                    + COLUMNS
                    + """
                       from users u join sessions s on s.user_id = u.id
                      where s.secret_hash = :hash and s.kind = :kind and s.expires_at > :now
                      """)
            .bind("hash", hash)
            .bind("kind", kind.name())
            .bind("now", now)
            .mapTo(OwnedSessionRow.class)
            .map(row -> new AuthenticatedSession(row.account(), row.session().toSession()))
            .findOne();
    login
        .map(AuthenticatedSession::session)
        .filter(session -> session.seenAt().plus(SEEN_RESOLUTION).isBefore(now))
        .ifPresent(session -> touch(handle, session, now));
    return login;
  }

  private static void touch(Handle handle, Session session, Instant now) {
    Instant end = session.kind() == Kind.BROWSER ? now.plus(LIFETIME) : session.expiresAt();
    handle.execute(
        "update sessions set seen_at = ?, expires_at = ? where id = ?", now, end, session.id());
  }

  private NewSession insert(
      Handle handle, Account user, Kind kind, @Nullable String name, Origin origin, Duration life) {
    Instant now = clock.instant().truncatedTo(ChronoUnit.MILLIS);
    String secret = Secret.random();
    handle.execute("delete from sessions where expires_at <= ?", now);
    long id =
        handle
            .createUpdate(
                """
                insert into sessions
                  (user_id, kind, name, secret_hash, address, agent, created_at, seen_at, expires_at)
                values (:user, :kind, :name, :hash, :address, :agent, :now, :now, :end)
                """)
            .bind("user", user.id())
            .bind("kind", kind.name())
            .bind("name", name)
            .bind("hash", Secret.hash(secret))
            .bind("address", origin.address())
            .bind("agent", origin.agent())
            .bind("now", now)
            .bind("end", now.plus(life))
            .executeAndReturnGeneratedKeys("id")
            .mapTo(Long.class)
            .one();
    return new NewSession(
        new Session(id, user.id(), kind, name, origin, now, now, now.plus(life)), secret);
  }

  /** A session among those of one user. */
  record ListedSessionRow(@Nested("session") SessionRow session) {}

  /** A session with its user. */
  record OwnedSessionRow(@Nested Account account, @Nested("session") SessionRow session) {}

  /** A row of the table of sessions. */
  record SessionRow(
      long id,
      long userId,
      Kind kind,
      @Nullable String name,
      String address,
      String agent,
      Instant createdAt,
      Instant seenAt,
      Instant expiresAt) {
    Session toSession() {
      return new Session(
          id, userId, kind, name, new Origin(address, agent), createdAt, seenAt, expiresAt);
    }
  }
}
