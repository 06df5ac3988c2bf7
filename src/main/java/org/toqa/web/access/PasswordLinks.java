package org.toqa.web.access;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.store.Account;
import org.toqa.store.Accounts;
import org.toqa.store.PasswordResets;
import org.toqa.web.Mail;
import org.toqa.web.Texts;

/**
 * Links by which forgotten passwords are replaced. Whoever forgot his gets one by e-mail; a manager
 * makes one for others.
 */
public final class PasswordLinks {
  private static final Logger LOG = LoggerFactory.getLogger(PasswordLinks.class);
  private static final Duration LIFE_OF_A_LETTER = Duration.ofHours(1);
  private static final Duration LIFE_BY_HAND = Duration.ofHours(24);
  private static final int LETTERS_AT_ONCE = 8;
  private static final int LONGEST_LOOKED_AT = 254;

  private final Accounts accounts;
  private final PasswordResets resets;
  private final @Nullable Mail mail;
  private final LoginThrottle throttle;
  private final Semaphore letters = new Semaphore(LETTERS_AT_ONCE);

  /**
   * @param mail null: no letters are sent
   */
  public PasswordLinks(
      Accounts accounts, PasswordResets resets, @Nullable Mail mail, InstantSource clock) {
    this.accounts = accounts;
    this.resets = resets;
    this.mail = mail;
    this.throttle = new LoginThrottle(clock);
  }

  public boolean areMailed() {
    return mail != null;
  }

  /**
   * Sends a letter to the users of that name or e-mail address, if there are any who may log in and
   * have one. Whether there are is neither told nor to be found out by the time that it takes.
   *
   * @param address where the wish comes from
   * @return zero, or how long until the next wish is looked at
   */
  public Duration mail(String nameOrEmail, String address, Texts texts) {
    String given = nameOrEmail.strip().toLowerCase(Locale.ROOT);
    String user = given.substring(0, Math.min(given.length(), LONGEST_LOOKED_AT));
    Duration wait = throttle.untilNext(user, address);
    if (!wait.isZero()) {
      return wait;
    }
    throttle.failed(user, address);
    if (mail != null && letters.tryAcquire()) {
      Mail by = mail;
      Thread.ofVirtual()
          .name("letter about a password")
          .start(
              () -> {
                try {
                  accounts.byNameOrEmail(user).forEach(account -> send(by, account, texts));
                } catch (StoreException e) {
                  LOG.warn("A link to replace a password was not made: {}", e.getMessage());
                } finally {
                  letters.release();
                }
              });
    }
    return Duration.ZERO;
  }

  private void send(Mail by, Account account, Texts texts) {
    String email = account.email();
    if (email == null || account.disabled()) {
      return;
    }
    String link = link(by.site(), resets.issue(account, LIFE_OF_A_LETTER, account.name()));
    try {
      by.send(
          email,
          texts.get("forgotten.letter.subject"),
          texts.get("forgotten.letter.text", account.name(), link, LIFE_OF_A_LETTER.toMinutes()));
    } catch (IOException e) {
      LOG.warn(
          "The letter to {} about his password was not sent: {}", account.name(), e.getMessage());
    }
  }

  /**
   * A link for a user to whom it is handed on.
   *
   * @param site the address of these pages, without a slash at its end
   * @param by the manager who makes it
   */
  public String byHand(Account user, String site, String by) {
    return link(mail == null ? site : mail.site(), resets.issue(user, LIFE_BY_HAND, by));
  }

  public static Duration lifeByHand() {
    return LIFE_BY_HAND;
  }

  /** The user whose password the link's secret replaces, while it is good. */
  public Optional<Account> user(String secret) {
    return resets.user(secret);
  }

  /** False when the link is not good any more: then nothing changes. */
  public boolean replace(String secret, String passwordHash) {
    return resets.replace(secret, passwordHash);
  }

  private static String link(String site, String secret) {
    return site + "/reset?secret=" + secret;
  }
}
