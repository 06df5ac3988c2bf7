package org.toqa.store;

import org.jdbi.v3.core.Handle;

/** The table of users, within a transaction of somebody else. */
final class AccountTable {
  /** Of {@code users u}. */
  static final String COLUMNS =
      "u.id, u.name, u.email, u.password_hash, u.role, u.disabled, u.created_at";

  private AccountTable() {}

  /** Ends what the old password, or a link to replace it, opened. */
  static void setPassword(Handle handle, long id, String passwordHash) {
    handle.execute("delete from sessions where user_id = ?", id);
    handle.execute("delete from password_resets where user_id = ?", id);
    handle.execute("update users set password_hash = ? where id = ?", passwordHash, id);
  }
}
