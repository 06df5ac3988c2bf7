package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.StatementContext;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Session;
import org.toqa.accounts.Session.Kind;
import org.toqa.accounts.Session.Origin;
import org.toqa.fleet.EventKind;
import org.toqa.wording.Phrase;

/** Who is logged in, from where, and by which secret. They outlive the server's process. */
public final class JdbiSessionStore {
  /**
   * Of a browser's session without use, and of a token that a login gave. Long enough for a shift.
   */
  public static final Duration LIFETIME = Duration.ofHours(12);

  /** Of more sessions of one user only the newest are listed. */
  private static final int MAX_LISTED = 200;

  /** How exactly it is known when a session was last used. */
  private static final Duration SEEN_RESOLUTION = Duration.ofMinutes(1);

  private static final String COLUMNS =
      "s.id as session_id, s.user_id as owner_id, s.kind, s.name as token_name, s.address, s.agent,"
          + " s.created_at as begun_at, s.seen_at, s.expires_at";

  private final SqlExecutor sql;
  private final InstantSource clock;
  private final FallbackCache<String, AuthenticatedSession> lastKnown = new FallbackCache<>();

  /** A session and the secret that is shown for it, which is told but once. */
  public record NewSession(Session session, String secret) {
    @Override
    public String toString() {
      return "Begun[" + session + "]";
    }
  }

  /** A session and its user. */
  public record AuthenticatedSession(Account account, Session session) {}

  public JdbiSessionStore(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  /** A user has logged in. Expired sessions of all users are removed on the way. */
  public NewSession begin(Account user, Kind kind, Origin origin) {
    return sql.inTransaction(handle -> insert(handle, user, kind, null, origin, LIFETIME));
  }

  /**
   * A token for a program of that user, which is told in the history.
   *
   * @param life how long it is good
   */
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

  /**
   * Whose secret it is, while it is good; what was said last, while the database is away. Asking
   * counts as use of the session.
   */
  public Optional<AuthenticatedSession> authenticate(Kind kind, String secret) {
    String hash = Secret.hash(secret);
    return lastKnown.get(
        kind + hash, () -> sql.withHandle(handle -> findAndTouch(handle, kind, hash)));
  }

  /** The newest first. */
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
                .bind("now", SqlExecutor.utc(clock.instant()))
                .map(JdbiSessionStore::mapSession)
                .list());
  }

  /**
   * False when that user has no such session.
   *
   * @param by who ends it
   */
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

  /** The holder of the secret logs out. */
  public void end(String secret) {
    sql.withHandle(
        handle ->
            handle.execute("delete from sessions where secret_hash = ?", Secret.hash(secret)));
  }

  static void endAll(Handle handle, long userId) {
    handle.execute("delete from sessions where user_id = ?", userId);
  }

  private Optional<AuthenticatedSession> findAndTouch(Handle handle, Kind kind, String hash) {
    Instant now = clock.instant();
    Optional<AuthenticatedSession> login =
        handle
            .createQuery(
                "select "
                    + JdbiAccountStore.columns()
                    + ", "
                    + COLUMNS
                    + """
                       from users u join sessions s on s.user_id = u.id
                      where s.secret_hash = :hash and s.kind = :kind and s.expires_at > :now
                      """)
            .bind("hash", hash)
            .bind("kind", kind.name())
            .bind("now", SqlExecutor.utc(now))
            .map(
                (row, context) ->
                    new AuthenticatedSession(
                        JdbiAccountStore.mapAccount(row, context), mapSession(row, context)))
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
        "update sessions set seen_at = ?, expires_at = ? where id = ?",
        SqlExecutor.utc(now),
        SqlExecutor.utc(end),
        session.id());
  }

  private NewSession insert(
      Handle handle, Account user, Kind kind, @Nullable String name, Origin origin, Duration life) {
    Instant now = clock.instant().truncatedTo(ChronoUnit.MILLIS);
    String secret = Secret.random();
    handle.execute("delete from sessions where expires_at <= ?", SqlExecutor.utc(now));
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
            .bind("now", SqlExecutor.utc(now))
            .bind("end", SqlExecutor.utc(now.plus(life)))
            .executeAndReturnGeneratedKeys("id")
            .mapTo(Long.class)
            .one();
    return new NewSession(
        new Session(id, user.id(), kind, name, origin, now, now, now.plus(life)), secret);
  }

  private static Session mapSession(ResultSet row, StatementContext context) throws SQLException {
    return new Session(
        row.getLong("session_id"),
        row.getLong("owner_id"),
        Kind.valueOf(row.getString("kind")),
        row.getString("token_name"),
        new Origin(row.getString("address"), row.getString("agent")),
        Rows.instant(row, "begun_at"),
        Rows.instant(row, "seen_at"),
        Rows.instant(row, "expires_at"));
  }
}
