package org.toqa.accounts;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Looks at a name and a password. */
public final class Authenticator {
  private static final Logger LOG = LoggerFactory.getLogger(Authenticator.class);
  private static final int MAX_CHECKED_LENGTH = 200;

  /** What came of an attempt. */
  public sealed interface Outcome {
    record Authenticated(Account account) implements Outcome {}

    /** Name or password is wrong; which one is not said. */
    record WrongCredentials() implements Outcome {}

    /** Name and password are right, but a manager has disabled the user. */
    record AccountDisabled() implements Outcome {}

    /** Not even looked at: too many failures before it. */
    record Throttled(Duration remaining) implements Outcome {
      /** The wait in whole seconds, at least one. */
      public long retryAfterSeconds() {
        return remaining.plusMillis(999).toSeconds();
      }
    }
  }

  private final AccountStore accounts;
  private final PasswordHasher passwords;
  private final LoginThrottle throttle;
  private final String site;

  /**
   * @param throttle of all sites together, so that guessing at many goes no faster
   * @param site whose accounts these are
   */
  public Authenticator(
      AccountStore accounts, PasswordHasher passwords, LoginThrottle throttle, Site site) {
    this.accounts = accounts;
    this.passwords = passwords;
    this.throttle = throttle;
    this.site = site.isFirst() ? "" : "@" + site.id();
  }

  /**
   * @param address where the attempt comes from
   */
  public Outcome authenticate(String name, String password, String address) {
    String key = name.substring(0, Math.min(name.length(), MAX_CHECKED_LENGTH));
    key = key.strip().toLowerCase(Locale.ROOT);
    String guessed = key + site;
    Duration wait = throttle.tryBegin(guessed, address);
    if (wait.isPositive()) {
      return new Outcome.Throttled(wait);
    }
    LoginThrottle.Result result = LoginThrottle.Result.UNKNOWN;
    try {
      Optional<Account> account = accounts.accountByName(key);
      boolean isOfSensibleLength = password.length() <= MAX_CHECKED_LENGTH;
      if (passwords.isCorrect(isOfSensibleLength ? password : "", account)) {
        result = LoginThrottle.Result.SUCCESS;
        return account.orElseThrow().disabled()
            ? new Outcome.AccountDisabled()
            : new Outcome.Authenticated(account.get());
      }
      result = LoginThrottle.Result.FAILURE;
      LOG.info("A login from {} failed.", address);
      return new Outcome.WrongCredentials();
    } finally {
      throttle.end(guessed, address, result);
    }
  }
}
