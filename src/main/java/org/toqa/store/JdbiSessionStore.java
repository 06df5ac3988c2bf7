package org.toqa.store;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.mapper.Nested;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Scope;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Session;
import org.toqa.accounts.Session.Carrier;
import org.toqa.accounts.Session.Kind;
import org.toqa.accounts.Session.Origin;
import org.toqa.accounts.SessionStore;
import org.toqa.accounts.Site;
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
          + " s.name as session_name, s.scopes as session_scopes, s.address as session_address, s.agent as session_agent,"
          + " s.created_at as session_created_at, s.seen_at as session_seen_at,"
          + " s.expires_at as session_expires_at";

  private final SqlExecutor sql;
  private final InstantSource clock;
  private final Duration limit;
  private final int perUser;
  private final Site site;
  private final LastKnownUsers lastKnown;

  /**
   * @param limit how long after its begin a login ends for good, in whatever use it is
   * @param perUser how many logins of each kind, and tokens, one user has at most
   * @param site which the secrets name
   */
  public JdbiSessionStore(
      Jdbi jdbi,
      InstantSource clock,
      Duration limit,
      int perUser,
      Site site,
      LastKnownUsers lastKnown) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
    this.limit = limit;
    this.perUser = perUser;
    this.site = site;
    this.lastKnown = lastKnown;
  }

  @Override
  public NewSession begin(Account user, Kind kind, Origin origin) {
    Duration life = kind.idleLimit().filter(idle -> idle.compareTo(limit) < 0).orElse(limit);
    return sql.inTransaction(
        handle -> {
          NewSession begun = insert(handle, user, kind, null, Scope.ALL, origin, life);
          endLeastUsed(handle, user, kind);
          return begun;
        });
  }

  /** What has expired is the least used; the rest of it goes with what else is old. */
  private void endLeastUsed(Handle handle, Account user, Kind kind) {
    handle
        .createQuery(
            """
            select id from sessions where user_id = :user and kind = :kind
            order by case when expires_at > :now then 0 else 1 end, seen_at desc, id desc
            limit :more offset :kept
            """)
        .bind("now", clock.instant())
        .bind("user", user.id())
        .bind("kind", kind.name())
        .bind("more", MAX_LISTED)
        .bind("kept", perUser)
        .mapTo(Long.class)
        .list()
        .forEach(id -> handle.execute("delete from sessions where id = ?", id));
  }

  @Override
  public boolean mayIssueToken(long userId) {
    return sql.withHandle(
        handle ->
            handle
                    .createQuery(
                        """
                        select count(*) from sessions
                         where user_id = :user and kind = :kind and expires_at > :now
                        """)
                    .bind("user", userId)
                    .bind("kind", Kind.TOKEN.name())
                    .bind("now", clock.instant())
                    .mapTo(Integer.class)
                    .one()
                < perUser);
  }

  @Override
  public NewSession issueToken(
      Account user, String name, Set<Scope> scopes, Origin origin, Duration life) {
    return sql.inTransaction(
        handle -> {
          EventTable.addAccountEvent(
              handle,
              clock.instant(),
              EventKind.USER_TOKEN,
              user.name(),
              Phrase.TOKEN_MADE.with(user.name(), name));
          return insert(handle, user, Kind.TOKEN, name, scopes, origin, life);
        });
  }

  @Override
  public Optional<AuthenticatedSession> authenticate(Carrier carrier, String secret) {
    return find(carrier, secret, true);
  }

  @Override
  public Optional<AuthenticatedSession> find(Carrier carrier, String secret) {
    return find(carrier, secret, false);
  }

  private Optional<AuthenticatedSession> find(Carrier carrier, String secret, boolean isUse) {
    String hash = Secret.hash(secret);
    return lastKnown
        .sessions
        .get(hash, () -> sql.withHandle(handle -> find(handle, hash, isUse)))
        .filter(login -> login.session().kind().carrier() == carrier)
        .filter(login -> !hasEnded(login.session()));
  }

  /** Also where the session was read before the store went away, or the limit was longer. */
  private boolean hasEnded(Session session) {
    Instant now = clock.instant();
    return !session.expiresAt().isAfter(now)
        || (session.kind() != Kind.TOKEN && !session.createdAt().plus(limit).isAfter(now));
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
    boolean ended = sql.inTransaction(handle -> end(handle, user, id, by));
    lastKnown.forget(user.id());
    return ended;
  }

  private boolean end(Handle handle, Account user, long id, String by) {
    boolean ended =
        handle.execute("delete from sessions where id = ? and user_id = ?", id, user.id()) > 0;
    if (ended) {
      EventTable.addAccountEvent(
          handle,
          clock.instant(),
          EventKind.USER_SESSION,
          by,
          Phrase.SESSION_ENDED.with(by, user.name()));
    }
    return ended;
  }

  @Override
  public void end(String secret) {
    String hash = Secret.hash(secret);
    sql.withHandle(handle -> handle.execute("delete from sessions where secret_hash = ?", hash));
    lastKnown.sessions.forget(hash);
  }

  private Optional<AuthenticatedSession> find(Handle handle, String hash, boolean isUse) {
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
                      where s.secret_hash = :hash and s.expires_at > :now
                      """)
            .bind("hash", hash)
            .bind("now", now)
            .mapTo(OwnedSessionRow.class)
            .map(row -> new AuthenticatedSession(row.account(), row.session().toSession()))
            .findOne();
    return isUse
        ? login.map(
            found -> new AuthenticatedSession(found.account(), used(handle, found.session(), now)))
        : login;
  }

  /** The session as it is after its use. */
  private Session used(Handle handle, Session session, Instant now) {
    if (!session.seenAt().plus(SEEN_RESOLUTION).isBefore(now)) {
      return session;
    }
    Instant end =
        session
            .kind()
            .idleLimit()
            .map(idle -> earlier(now.plus(idle), session.createdAt().plus(limit)))
            .orElse(session.expiresAt());
    handle.execute(
        "update sessions set seen_at = ?, expires_at = ? where id = ?", now, end, session.id());
    return session.withUse(now, end);
  }

  private static Instant earlier(Instant one, Instant other) {
    return one.isBefore(other) ? one : other;
  }

  private NewSession insert(
      Handle handle,
      Account user,
      Kind kind,
      @Nullable String name,
      Set<Scope> scopes,
      Origin origin,
      Duration life) {
    Instant now = clock.instant().truncatedTo(ChronoUnit.MILLIS);
    String secret = Secret.random(site.id());
    long id =
        handle
            .createUpdate(
                """
                insert into sessions
                  (user_id, kind, name, scopes, secret_hash, address, agent, created_at, seen_at, expires_at)
                values (:user, :kind, :name, :scopes, :hash, :address, :agent, :now, :now, :end)
                """)
            .bind("user", user.id())
            .bind("kind", kind.name())
            .bind("name", name)
            .bind("scopes", kind == Kind.TOKEN ? SessionRow.names(scopes) : null)
            .bind("hash", Secret.hash(secret))
            .bind("address", origin.address())
            .bind("agent", origin.agent())
            .bind("now", now)
            .bind("end", now.plus(life))
            .executeAndReturnGeneratedKeys("id")
            .mapTo(Long.class)
            .one();
    return new NewSession(
        new Session(id, user.id(), kind, name, scopes, origin, now, now, now.plus(life)), secret);
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
      @Nullable String scopes,
      String address,
      String agent,
      Instant createdAt,
      Instant seenAt,
      Instant expiresAt) {
    Session toSession() {
      return new Session(
          id,
          userId,
          kind,
          name,
          scopes == null ? Scope.ALL : scopes(scopes),
          new Origin(address, agent),
          createdAt,
          seenAt,
          expiresAt);
    }

    static String names(Set<Scope> scopes) {
      return scopes.stream().sorted().map(Scope::name).collect(Collectors.joining(","));
    }

    private static Set<Scope> scopes(String names) {
      return Arrays.stream(names.split(",", -1))
          .filter(name -> !name.isEmpty())
          .map(Scope::valueOf)
          .collect(Collectors.toUnmodifiableSet());
    }
  }
}
