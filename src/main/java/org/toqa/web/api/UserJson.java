package org.toqa.web.api;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;

/** A user on the wire. */
record UserJson(
    long id, String name, @Nullable String email, Role role, boolean disabled, Instant createdAt) {
  static UserJson of(Account account) {
    return new UserJson(
        account.id(),
        account.name(),
        account.email(),
        account.role(),
        account.disabled(),
        account.createdAt());
  }
}
