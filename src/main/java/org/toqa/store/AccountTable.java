package org.toqa.store;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.persistence.StoreException;

/** The table of users, within a transaction of somebody else. */
final class AccountTable {
  /** Of {@code users u}. */
  static final String COLUMNS =
      "u.id, u.name, u.email, u.password_hash, u.role, u.disabled, u.created_at";

  private static final String UNCHANGED =
      " where id = :id and role = :seenRole and disabled = :seenDisabled"
          + " and coalesce(email, '') = :seenEmail";

  private AccountTable() {}

  /**
   * Changes a user who is still as he was seen.
   *
   * @param assignments of columns of {@code users} to {@code values}
   * @return whether he is
   */
  static boolean updateUnchanged(
      Handle handle, Account seen, String assignments, Map<String, ?> values) {
    String email = seen.email();
    return handle
            .createUpdate("update users set " + assignments + UNCHANGED)
            .bindMap(values)
            .bind("id", seen.id())
            .bind("seenRole", seen.role().name())
            .bind("seenDisabled", seen.disabled())
            .bind("seenEmail", email == null ? "" : email)
            .execute()
        == 1;
  }

  /** The id of the user who has that name now, in any case. */
  static Optional<Long> idOf(Handle handle, String name) {
    return handle
        .createQuery("select id from users where name_key = :key")
        .bind("key", name.toLowerCase(Locale.ROOT))
        .mapTo(Long.class)
        .findOne();
  }

  /**
   * Whose the new thing is, which is stored in the same transaction: until its end nobody disables
   * or deletes him, so who deletes him finds all that is his ({@link JdbiAccountStore#delete}).
   *
   * @param account his id; null: whoever has the name now
   * @return null: nobody has the name
   * @throws StoreException the account may not log in, or is there no more
   */
  static @Nullable Long ownerOfNew(Handle handle, String name, @Nullable Long account) {
    if (account == null) {
      return idOf(handle, name).orElse(null);
    }
    return handle
        .createQuery("select id from users where id = :id and not disabled for update")
        .bind("id", account)
        .mapTo(Long.class)
        .findOne()
        .orElseThrow(
            () ->
                new StoreException(
                    StoreException.Kind.UNKNOWN_USER, name + " may not log in any more.", null));
  }

  /** Ends what the old password, or a link to replace it, opened. */
  static void setPassword(Handle handle, long id, String passwordHash) {
    handle.execute("delete from sessions where user_id = ?", id);
    handle.execute("delete from reset_links where user_id = ?", id);
    handle.execute("update users set password_hash = ? where id = ?", passwordHash, id);
  }
}
