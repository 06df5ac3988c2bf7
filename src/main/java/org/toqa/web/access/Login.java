package org.toqa.web.access;

import java.time.Duration;
import java.time.InstantSource;
import java.util.Locale;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.store.Account;
import org.toqa.store.Accounts;

/** Looks at a name and a password. */
public final class Login {
  private static final Logger LOG = LoggerFactory.getLogger(Login.class);
  private static final int LONGEST_LOOKED_AT = 200;

  /** What came of an attempt. */
  public sealed interface Outcome {
    record Welcome(Account account) implements Outcome {}

    /** Name or password is wrong; which one is not said. */
    record Wrong() implements Outcome {}

    /** Name and password are right, but a manager has disabled the user. */
    record Disabled() implements Outcome {}

    /** Not even looked at: too many failures before it. */
    record TooSoon(Duration remaining) implements Outcome {
      /** The wait in whole seconds, at least one. */
      public long seconds() {
        return remaining.plusMillis(999).toSeconds();
      }
    }
  }

  private final Accounts accounts;
  private final Passwords passwords;
  private final LoginThrottle throttle;

  private Login(Accounts accounts, Passwords passwords, LoginThrottle throttle) {
    this.accounts = accounts;
    this.passwords = passwords;
    this.throttle = throttle;
  }

  public static Login of(Accounts accounts, Passwords passwords, InstantSource clock) {
    return new Login(accounts, passwords, new LoginThrottle(clock));
  }

  /**
   * @param address where the attempt comes from
   */
  public Outcome attempt(String name, String password, String address) {
    String key = name.substring(0, Math.min(name.length(), LONGEST_LOOKED_AT));
    key = key.strip().toLowerCase(Locale.ROOT);
    Duration wait = throttle.untilNext(key, address);
    if (wait.isPositive()) {
      return new Outcome.TooSoon(wait);
    }
    Optional<Account> account = accounts.byName(key);
    boolean sensible = password.length() <= LONGEST_LOOKED_AT;
    if (passwords.matches(sensible ? password : "", account)) {
      throttle.succeeded(key);
      return account.orElseThrow().disabled()
          ? new Outcome.Disabled()
          : new Outcome.Welcome(account.get());
    }
    throttle.failed(key, address);
    LOG.info("A login from {} failed.", address);
    return new Outcome.Wrong();
  }
}
