package org.toqa.web;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.store.Account;
import org.toqa.store.Accounts;
import org.toqa.web.access.Caller;

/** Does what a person wants of a user, whether it came by a form or by the wire. */
public final class UserWishes {
  private final Services services;
  private final Texts texts;
  private final FieldErrors errors;

  public UserWishes(Services services, Texts texts, FieldErrors errors) {
    this.services = services;
    this.texts = texts;
    this.errors = errors;
  }

  /** A user changes his own password, a manager all. */
  public static boolean mayChangePassword(Caller caller, Account user) {
    return caller.isManager() || isOwn(caller, user);
  }

  public static boolean isOwn(Caller caller, Account user) {
    return caller.account().id() == user.id();
  }

  /**
   * A user who changes his own must know the old one. Sessions and tokens of the user end.
   *
   * @param field that gets the sentence when it is refused
   */
  public void changePassword(
      Caller caller, Account user, String field, @Nullable String given, @Nullable String old) {
    String password = new InputRules(texts, errors).newPassword(field, given, user.name());
    if (isOwn(caller, user)
        && !services.passwords().matches(old == null ? "" : old, Optional.of(user))) {
      errors.add(field, texts.get("error.password.old"));
    }
    if (errors.isEmpty()) {
      services
          .accounts()
          .changePassword(user.id(), services.passwords().hash(password), caller.name());
    }
  }

  /** Why it could not be done, a sentence; empty: it is done. */
  public Optional<String> refusal(Accounts.Outcome outcome) {
    return switch (outcome) {
      case DONE -> Optional.empty();
      case UNKNOWN -> Optional.of(texts.get("problem.noSuchUser"));
      case LAST_MANAGER -> Optional.of(texts.get("error.lastManager"));
    };
  }
}
