package org.toqa.accounts;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The users of the web application. There is always at least one manager who can sign in once there
 * has been one. Every change is told in the history, with who made it.
 *
 * <p>Any thread may call it and may have to wait. Every method throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer.
 */
public interface AccountStore {

  /** What came of a change of an account. */
  enum ChangeResult {
    DONE,
    NO_SUCH_ACCOUNT,
    /** Refused: it was changed since it was read. */
    OUTDATED,
    /** Refused: nobody would be left to manage the others. */
    LAST_MANAGER,
    /** Refused: nobody would be left to make sites. */
    LAST_ADMINISTRATOR,
    /** Refused: open tasks are his, and their loads are not on their way to where they end. */
    OPEN_TASKS
  }

  /** Whether there is a manager who can sign in. */
  boolean hasManager();

  /** All of them by name. */
  List<Account> accounts();

  /** The account as it was read last while the store does not answer. */
  Optional<Account> account(long id);

  /** The account of that name in any case. */
  Optional<Account> accountByName(String name);

  /** The account of that name, or else all of that e-mail address, in any case. */
  List<Account> accountsByNameOrEmail(String nameOrEmail);

  /**
   * Adds an account without an e-mail address.
   *
   * @param by who does it
   * @return empty when the name is taken
   */
  default Optional<Account> add(String name, String passwordHash, Role role, String by) {
    return add(name, null, passwordHash, role, by);
  }

  /**
   * Adds an account.
   *
   * @param email where a link goes when the password is forgotten; null: nowhere
   * @param by who does it
   * @return empty when the name is taken
   */
  Optional<Account> add(
      String name, @Nullable String email, String passwordHash, Role role, String by);

  /**
   * Adds a manager where there is none, who is also administrator.
   *
   * @return empty when there is a manager already, or a user of that name
   */
  Optional<Account> addFirstManager(String name, String passwordHash);

  default ChangeResult update(long id, Role role, boolean disabled, String by) {
    return update(id, role, disabled, null, by);
  }

  /**
   * Changes what the user may do; it holds from his next request on, and of who is disabled nothing
   * is stored any more that was under way. A name stays: tasks and history go by it.
   *
   * @param seen the account as it was read: another role, address or right to sign in than that is
   *     not overwritten; null: whatever it is
   * @param by who does it
   */
  ChangeResult update(long id, Role role, boolean disabled, @Nullable Account seen, String by);

  /** Removes the account with all that is the user's. */
  default ChangeResult delete(long id, String by) {
    return delete(id, Handover.NONE, by);
  }

  /**
   * Removes the account, unless the last manager would be gone or robots would go on carrying what
   * is nobody's. From then on nothing new is stored as his; what of his tasks ends by itself, and
   * his past ones, are nobody's.
   *
   * @param id the account's
   * @param handover who gets his schedules and tokens
   * @param by who does it
   * @return {@code LAST_MANAGER}, {@code LAST_ADMINISTRATOR} and {@code OPEN_TASKS} are refusals:
   *     nothing changes then
   */
  ChangeResult delete(long id, Handover handover, String by);

  /**
   * Also ends the user's sessions, tokens and links to replace the password.
   *
   * @param by who does it
   * @return false when there is no such user
   */
  boolean changePassword(long id, String passwordHash, String by);

  /**
   * Changes where a link goes when the password is forgotten, and ends the link that is out.
   *
   * @param email null: nowhere
   * @param seen as of {@link #update}
   * @param by who does it
   */
  ChangeResult changeEmail(long id, @Nullable String email, @Nullable Account seen, String by);
}
