package org.toqa.store;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.toqa.accounts.Account;

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

  /** Ends what the old password, or a link to replace it, opened. */
  static void setPassword(Handle handle, long id, String passwordHash) {
    handle.execute("delete from sessions where user_id = ?", id);
    handle.execute("delete from reset_links where user_id = ?", id);
    handle.execute("update users set password_hash = ? where id = ?", passwordHash, id);
  }
}
