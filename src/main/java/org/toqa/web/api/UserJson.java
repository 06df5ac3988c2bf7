package org.toqa.web.api;

import java.time.Instant;
import org.toqa.store.Account;
import org.toqa.store.Role;

/** A user on the wire. */
record UserJson(long id, String name, Role role, boolean disabled, Instant createdAt) {
  static UserJson of(Account account) {
    return new UserJson(
        account.id(), account.name(), account.role(), account.disabled(), account.createdAt());
  }
}
