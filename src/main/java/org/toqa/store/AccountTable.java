package org.toqa.store;

import java.util.Locale;
import java.util.Optional;
import org.jdbi.v3.core.Handle;

/** The table of users, within a transaction of somebody else. */
final class AccountTable {
  /** Of {@code users u}. */
  static final String COLUMNS =
      "u.id, u.name, u.email, u.password_hash, u.role, u.disabled, u.created_at";

  private AccountTable() {}

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
