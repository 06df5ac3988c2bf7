package org.toqa.store;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.toqa.accounts.Account;
import org.toqa.accounts.PasswordResetStore;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Site;
import org.toqa.fleet.EventKind;
import org.toqa.wording.Phrase;

/**
 * Secrets by which a forgotten password is replaced, each once and for a while. The one that is
 * used ends all of its user.
 */
public final class JdbiPasswordResetStore implements PasswordResetStore {
  private final SqlExecutor sql;
  private final InstantSource clock;

  private final Site site;
  private final LastKnownUsers lastKnown;

  /**
   * @param site which the secrets name
   */
  public JdbiPasswordResetStore(
      Jdbi jdbi, InstantSource clock, Site site, LastKnownUsers lastKnown) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
    this.site = site;
    this.lastKnown = lastKnown;
  }

  @Override
  public String issue(Account user, Duration life, String by) {
    String secret = Secret.random(site.id());
    Instant now = clock.instant();
    return sql.inTransaction(
        handle -> {
          handle.execute(
              "insert into reset_links (user_id, secret_hash, expires_at) values (?, ?, ?)",
              user.id(),
              Secret.hash(secret),
              now.plus(life));
          EventTable.addAccountEvent(
              handle, now, EventKind.USER_RESET, by, Phrase.PASSWORD_LINK_MADE.with(user.name()));
          return secret;
        });
  }

  @Override
  public void revoke(Account user) {
    sql.withHandle(
        handle -> handle.execute("delete from reset_links where user_id = ?", user.id()));
  }

  @Override
  public Optional<Account> account(String secret) {
    return sql.withHandle(handle -> findAccount(handle, secret));
  }

  @Override
  public boolean replacePassword(String secret, String passwordHash) {
    Optional<Account> user =
        sql.inTransaction(handle -> replacePassword(handle, secret, passwordHash));
    user.ifPresent(changed -> lastKnown.forget(changed.id()));
    return user.isPresent();
  }

  /** Empty: the link is good no more. */
  private Optional<Account> replacePassword(Handle handle, String secret, String passwordHash) {
    Optional<Account> user = findAccount(handle, secret);
    boolean isFirst =
        handle.execute("delete from reset_links where secret_hash = ?", Secret.hash(secret)) > 0;
    if (user.isEmpty() || !isFirst) {
      return Optional.empty();
    }
    String name = user.get().name();
    AccountTable.setPassword(handle, user.get().id(), passwordHash);
    EventTable.addAccountEvent(
        handle,
        clock.instant(),
        EventKind.USER_PASSWORD,
        name,
        Phrase.PASSWORD_REPLACED.with(name));
    return user;
  }

  private Optional<Account> findAccount(Handle handle, String secret) {
    return handle
        .createQuery(
            "select "
                + AccountTable.COLUMNS
                + """
                   from users u join reset_links p on p.user_id = u.id
                  where p.secret_hash = :hash and p.expires_at > :now
                  """)
        .bind("hash", Secret.hash(secret))
        .bind("now", clock.instant())
        .mapTo(Account.class)
        .findOne();
  }
}
