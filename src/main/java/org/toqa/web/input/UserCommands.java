package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Authenticator;
import org.toqa.accounts.Scope;
import org.toqa.accounts.Session;
import org.toqa.accounts.SessionStore;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.RequestOrigin;

/** Changes of a user that a person asks for, by a form or by the API. */
public final class UserCommands {
  private final Services services;
  private final Texts texts;
  private final FieldErrors errors;
  private final Session.Origin origin;

  private UserCommands(Services services, Texts texts, FieldErrors errors, Session.Origin origin) {
    this.services = services;
    this.texts = texts;
    this.errors = errors;
    this.origin = origin;
  }

  public static UserCommands of(HttpServletRequest request, FieldErrors errors) {
    return new UserCommands(
        Services.of(request), Texts.of(request), errors, RequestOrigin.of(request));
  }

  /** A user sees and changes himself, a manager all. */
  public static boolean canSee(Caller caller, Account user) {
    return caller.isManager() || isSelf(caller, user);
  }

  /** An administrator is changed by himself and by others of them only. */
  public static boolean canChange(Caller caller, Account user) {
    return canSee(caller, user)
        && (!user.isAdministrator() || caller.isAdministrator() || isSelf(caller, user));
  }

  public static boolean isSelf(Caller caller, Account user) {
    return caller.account().id() == user.id();
  }

  /** A user who changes his own must know the old one. Sessions and tokens of the user end. */
  public void changePassword(
      Caller caller, Account user, @Nullable String given, @Nullable String old) {
    String password = new InputRules(texts, errors).newPassword("password", given, user.name());
    checkPassword(caller, user, "old", old);
    if (errors.isEmpty()) {
      services
          .accounts()
          .changePassword(user.id(), services.passwordHasher().hash(password), caller.name());
    }
  }

  /**
   * A user who changes his own must know his password, for a link to replace it goes there.
   *
   * @param seen as of {@link AccountStore#update}
   * @param given null: none any more
   * @param passwordField that gets the sentence when the password is wrong
   */
  public void changeEmail(
      Caller caller,
      Account user,
      @Nullable Account seen,
      @Nullable String given,
      String passwordField,
      @Nullable String password) {
    String email = new InputRules(texts, errors).email("email", given);
    checkPassword(caller, user, passwordField, password);
    if (errors.isEmpty()) {
      refusal(services.accounts().changeEmail(user.id(), email, seen, caller.name()), texts)
          .ifPresent(sentence -> errors.add("form", sentence));
    }
  }

  /**
   * What a new token shall be.
   *
   * @param days of its lifetime
   * @param scopes words of {@link Scope}
   * @param password of the user, given again
   */
  public record TokenOrder(
      @Nullable String name,
      @Nullable Double days,
      List<String> scopes,
      @Nullable String password) {}

  /**
   * A token for the user's own programs. He makes it in his browser, with his password given again:
   * a token makes no tokens, and who finds an open page makes none either.
   *
   * @param nameField that gets the sentence when the name is refused
   * @param passwordField that gets the sentence when the password is wrong
   */
  public Optional<SessionStore.NewSession> createToken(
      Caller caller, Account user, String nameField, String passwordField, TokenOrder order) {
    InputRules rules = new InputRules(texts, errors);
    String name = rules.tokenName(nameField, order.name());
    int days = rules.tokenDays("days", order.days());
    Set<Scope> scopes = rules.scopes("scopes", order.scopes());
    if (!isSelf(caller, user)) {
      errors.add("form", texts.get("problem.notYourToken"));
    } else if (!caller.session().mayCreateTokens()) {
      errors.add("form", texts.get("problem.tokenInBrowser"));
    } else if (!services.sessions().mayIssueToken(user.id())) {
      errors.add("form", texts.get("error.token.tooMany"));
    }
    if (errors.isEmpty()) {
      checkPassword(caller, user, passwordField, order.password());
    }
    return errors.isEmpty()
        ? Optional.of(
            services.sessions().issueToken(user, name, scopes, origin, Duration.ofDays(days)))
        : Optional.empty();
  }

  private void checkPassword(Caller caller, Account user, String field, @Nullable String password) {
    if (!isSelf(caller, user)) {
      return;
    }
    switch (services
        .authenticator()
        .authenticate(user.name(), password == null ? "" : password, origin.address())) {
      case Authenticator.Outcome.Authenticated login -> {}
      case Authenticator.Outcome.Throttled throttled ->
          errors.add(
              field, texts.get("error.login.tooManyAttempts", throttled.retryAfterSeconds()));
      default -> errors.add(field, texts.get("error.password.old"));
    }
  }

  /** Why it could not be done, a sentence; empty: it is done. */
  public static Optional<String> refusal(AccountStore.ChangeResult outcome, Texts texts) {
    return switch (outcome) {
      case DONE -> Optional.empty();
      case NO_SUCH_ACCOUNT -> Optional.of(texts.get("problem.noSuchUser"));
      case OUTDATED -> Optional.of(texts.get("error.changed"));
      case LAST_MANAGER -> Optional.of(texts.get("error.lastManager"));
      case LAST_ADMINISTRATOR -> Optional.of(texts.get("error.lastAdministrator"));
      case OPEN_TASKS -> Optional.of(texts.get("error.delete.unfinished"));
    };
  }
}
