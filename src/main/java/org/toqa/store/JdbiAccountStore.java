package org.toqa.store;

import java.sql.SQLIntegrityConstraintViolationException;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.JdbiException;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Handover;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventKind;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The users of the web application. There is always at least one manager who can log in once there
 * has been one. Every change is told in the history, by whom too.
 *
 * <p>One server writes to a database, so the two rules that span rows (the first manager, the last
 * manager) are kept by this object's lock rather than by the database's.
 */
public final class JdbiAccountStore implements AccountStore {
  private final SqlExecutor sql;
  private final InstantSource clock;

  private final LastKnownUsers lastKnown;

  /** There was a manager, so there always is one. */
  private volatile boolean managerExists;

  public JdbiAccountStore(Jdbi jdbi, InstantSource clock, LastKnownUsers lastKnown) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
    this.lastKnown = lastKnown;
  }

  @Override
  public boolean hasManager() {
    if (!managerExists) {
      managerExists = sql.withHandle(handle -> managerCount(handle) > 0);
    }
    return managerExists;
  }

  @Override
  public List<Account> accounts() {
    return sql.withHandle(
        handle ->
            handle
                .createQuery("select " + AccountTable.COLUMNS + " from users u order by u.name_key")
                .mapTo(Account.class)
                .list());
  }

  @Override
  public Optional<Account> account(long id) {
    return lastKnown.accounts.get(id, () -> sql.withHandle(handle -> find(handle, id)));
  }

  @Override
  public Optional<Account> accountByName(String name) {
    return sql.withHandle(
        handle ->
            handle
                .createQuery(
                    "select " + AccountTable.COLUMNS + " from users u where u.name_key = :key")
                .bind("key", nameKey(name))
                .mapTo(Account.class)
                .findOne());
  }

  @Override
  public List<Account> accountsByNameOrEmail(String given) {
    return accountByName(given).map(List::of).orElseGet(() -> accountsByEmail(given));
  }

  private List<Account> accountsByEmail(String email) {
    return sql.withHandle(
        handle ->
            handle
                .createQuery(
                    "select "
                        + AccountTable.COLUMNS
                        + " from users u where lower(u.email) = :email")
                .bind("email", nameKey(email))
                .mapTo(Account.class)
                .list());
  }

  @Override
  public Optional<Account> add(
      String name, @Nullable String email, String passwordHash, Role role, String by) {
    try {
      return Optional.of(
          sql.inTransaction(
              handle -> {
                Account account = insert(handle, name, email, passwordHash, role);
                recordEvent(handle, EventKind.USER_ADDED, by, Phrase.USER_ADDED.with(by, name));
                return account;
              }));
    } catch (StoreException e) {
      if (e.getCause() instanceof JdbiException refused
          && refused.getCause() instanceof SQLIntegrityConstraintViolationException) {
        return Optional.empty();
      }
      throw e;
    }
  }

  private void recordEvent(Handle handle, EventKind kind, String by, Sentence said) {
    EventTable.addAccountEvent(handle, clock.instant(), kind, by, said);
  }

  @Override
  public synchronized Optional<Account> addFirstManager(String name, String passwordHash) {
    return hasManager() ? Optional.empty() : add(name, passwordHash, Role.ADMINISTRATOR, name);
  }

  @Override
  public synchronized ChangeResult delete(long id, Handover handover, String by) {
    return change(
        id,
        handle -> {
          handle
              .select("select id from users where id = ? for update", id)
              .mapTo(Long.class)
              .list();
          Optional<Account> account = find(handle, id);
          if (account.isEmpty()) {
            return ChangeResult.NO_SUCH_ACCOUNT;
          }
          Optional<ChangeResult> refusal = refusalToLose(handle, account.get(), null);
          if (refusal.isPresent()) {
            return refusal.get();
          }
          if (TaskTable.isAnyLeftTo(handle, id)) {
            return ChangeResult.OPEN_TASKS;
          }
          LeftBehind left = new LeftBehind(handle, account.get(), clock.instant(), by);
          left.handOverSchedules(handover.schedules());
          left.handOverTokens(handover.tokens());
          handle.execute("delete from users where id = ?", id);
          recordEvent(
              handle,
              EventKind.USER_DELETED,
              by,
              Phrase.USER_DELETED.with(by, account.get().name()));
          return ChangeResult.DONE;
        });
  }

  @Override
  public synchronized ChangeResult update(
      long id, Role role, boolean disabled, @Nullable Account seen, String by) {
    return change(
        id,
        handle -> {
          Optional<Account> found = find(handle, id);
          if (found.isEmpty()) {
            return ChangeResult.NO_SUCH_ACCOUNT;
          }
          Account old = found.get();
          Optional<ChangeResult> refusal = refusalToLose(handle, old, disabled ? null : role);
          if (refusal.isPresent()) {
            return refusal.get();
          }
          if (!AccountTable.updateUnchanged(
              handle,
              seen == null ? old : seen,
              "role = :role, disabled = :disabled",
              Map.of("role", role.name(), "disabled", disabled))) {
            return ChangeResult.OUTDATED;
          }
          if (role != old.role() || disabled != old.disabled()) {
            recordEvent(
                handle, EventKind.USER_CHANGED, by, changeSentence(old, role, disabled, by));
          }
          return ChangeResult.DONE;
        });
  }

  private static Sentence changeSentence(Account old, Role role, boolean disabled, String by) {
    Phrase phrase =
        switch (role) {
          case VIEWER -> Phrase.USER_MADE_VIEWER;
          case CLERK -> Phrase.USER_MADE_CLERK;
          case OPERATOR -> Phrase.USER_MADE_OPERATOR;
          case MANAGER -> Phrase.USER_MADE_MANAGER;
          case ADMINISTRATOR -> Phrase.USER_MADE_ADMINISTRATOR;
        };
    Sentence made = phrase.with(by, old.name());
    return disabled ? Phrase.WHO_MAY_NOT_LOG_IN.with(made) : made;
  }

  /**
   * @param next what he may do then; null: he can sign in no more
   */
  private static Optional<ChangeResult> refusalToLose(
      Handle handle, Account account, @Nullable Role next) {
    if (account.disabled()) {
      return Optional.empty();
    }
    boolean staysManager = next != null && next.isManager();
    if (account.isManager() && !staysManager && managerCount(handle) == 1) {
      return Optional.of(ChangeResult.LAST_MANAGER);
    }
    return account.isAdministrator()
            && next != Role.ADMINISTRATOR
            && count(handle, "role = 'ADMINISTRATOR'") == 1
        ? Optional.of(ChangeResult.LAST_ADMINISTRATOR)
        : Optional.empty();
  }

  @Override
  public boolean changePassword(long id, String passwordHash, String by) {
    return change(
        id,
        handle -> {
          Optional<Account> account = find(handle, id);
          if (account.isEmpty()) {
            return false;
          }
          AccountTable.setPassword(handle, id, passwordHash);
          recordEvent(
              handle,
              EventKind.USER_PASSWORD,
              by,
              Phrase.PASSWORD_CHANGED.with(by, account.get().name()));
          return true;
        });
  }

  @Override
  public ChangeResult changeEmail(
      long id, @Nullable String email, @Nullable Account seen, String by) {
    return change(
        id,
        handle -> {
          Optional<Account> found = find(handle, id);
          if (found.isEmpty()) {
            return ChangeResult.NO_SUCH_ACCOUNT;
          }
          Account old = found.get();
          if (!AccountTable.updateUnchanged(
              handle,
              seen == null ? old : seen,
              "email = :email",
              Collections.singletonMap("email", email))) {
            return ChangeResult.OUTDATED;
          }
          if (!Objects.equals(old.email(), email)) {
            handle.execute("delete from reset_links where user_id = ?", id);
            recordEvent(
                handle, EventKind.USER_CHANGED, by, Phrase.EMAIL_CHANGED.with(by, old.name()));
          }
          return ChangeResult.DONE;
        });
  }

  private <T> T change(long id, Function<Handle, T> change) {
    T result = sql.inTransaction(change);
    lastKnown.forget(id);
    return result;
  }

  private static Optional<Account> find(Handle handle, long id) {
    return handle
        .createQuery("select " + AccountTable.COLUMNS + " from users u where u.id = :id")
        .bind("id", id)
        .mapTo(Account.class)
        .findOne();
  }

  private Account insert(
      Handle handle, String name, @Nullable String email, String passwordHash, Role role) {
    Instant now = clock.instant().truncatedTo(ChronoUnit.MILLIS);
    long id =
        handle
            .createUpdate(
                """
                insert into users (name, name_key, email, password_hash, role, created_at)
                values (:name, :key, :email, :hash, :role, :now)
                """)
            .bind("name", name)
            .bind("key", nameKey(name))
            .bind("email", email)
            .bind("hash", passwordHash)
            .bind("role", role.name())
            .bind("now", now)
            .executeAndReturnGeneratedKeys("id")
            .mapTo(Long.class)
            .one();
    return new Account(id, name, email, passwordHash, role, false, now);
  }

  private static int managerCount(Handle handle) {
    return count(handle, "role in ('MANAGER', 'ADMINISTRATOR')");
  }

  /** Of those who can sign in. */
  private static int count(Handle handle, String condition) {
    return handle
        .createQuery("select count(*) from users where not disabled and " + condition)
        .mapTo(Integer.class)
        .one();
  }

  private static String nameKey(String name) {
    return name.toLowerCase(Locale.ROOT);
  }
}
