package org.toqa.web;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.LoginThrottle;
import org.toqa.accounts.PasswordResetStore;
import org.toqa.persistence.StoreException;

/**
 * Links by which forgotten passwords are replaced. Whoever forgot his gets one by e-mail; a manager
 * makes one for others. A stranger who asks again and again takes nobody's link away: a letter ends
 * none before it, and a user gets one in a while.
 */
public final class PasswordLinks {
  private static final Logger LOG = LoggerFactory.getLogger(PasswordLinks.class);
  private static final Duration MAILED_LINK_LIFETIME = Duration.ofHours(1);
  private static final Duration CREATED_LINK_LIFETIME = Duration.ofHours(24);
  private static final int MAX_CONCURRENT_MAILS = 8;

  /** Letters that wait while others are slow; one for each user, so a site has not more. */
  private static final int MAX_WAITING_MAILS = 1000;

  private static final Duration MIN_TIME_BETWEEN_MAILS = Duration.ofMinutes(1);
  private static final int MAX_CHECKED_LENGTH = 254;

  private final AccountStore accounts;
  private final PasswordResetStore resets;
  private final @Nullable MailSender mail;
  private final LoginThrottle throttle;
  private final Semaphore mailPermits = new Semaphore(MAX_CONCURRENT_MAILS);
  private final Semaphore waitingMails = new Semaphore(MAX_WAITING_MAILS);

  /** Accounts that were sent a letter a moment ago. */
  private final Cache<Long, Boolean> justMailed;

  /**
   * @param mail null: no e-mails are sent
   */
  public PasswordLinks(
      AccountStore accounts,
      PasswordResetStore resets,
      @Nullable MailSender mail,
      InstantSource clock) {
    this.accounts = accounts;
    this.resets = resets;
    this.mail = mail;
    this.throttle = new LoginThrottle(clock);
    this.justMailed =
        Caffeine.newBuilder()
            .expireAfterWrite(MIN_TIME_BETWEEN_MAILS)
            .ticker(() -> TimeUnit.MILLISECONDS.toNanos(clock.millis()))
            .executor(Runnable::run)
            .build();
  }

  public boolean canMail() {
    return mail != null;
  }

  /**
   * Sends an e-mail to the users of that name or e-mail address, if there are any who may log in
   * and have one. Neither the answer nor its time shows whether there are.
   *
   * @param address where the request comes from
   * @return zero, or how long until the next request is looked at
   */
  public Duration sendLink(String nameOrEmail, String address, Texts texts) {
    String given = nameOrEmail.strip().toLowerCase(Locale.ROOT);
    String user = given.substring(0, Math.min(given.length(), MAX_CHECKED_LENGTH));
    Duration wait = throttle.tryBegin(user, address);
    if (!wait.isZero()) {
      return wait;
    }
    throttle.end(user, address, LoginThrottle.Result.FAILURE);
    if (mail != null && waitingMails.tryAcquire()) {
      MailSender sender = mail;
      Thread.ofVirtual()
          .name("password e-mail")
          .start(
              () -> {
                try {
                  accounts
                      .accountsByNameOrEmail(user)
                      .forEach(account -> send(sender, account, texts));
                } catch (StoreException e) {
                  LOG.warn("A link to replace a password was not made: {}", e.getMessage());
                } finally {
                  waitingMails.release();
                }
              });
    }
    return Duration.ZERO;
  }

  private void send(MailSender sender, Account account, Texts texts) {
    String email = account.email();
    if (email == null
        || account.disabled()
        || justMailed.asMap().putIfAbsent(account.id(), true) != null) {
      return;
    }
    mailPermits.acquireUninterruptibly();
    try {
      send(sender, account, email, texts);
    } finally {
      mailPermits.release();
    }
  }

  private void send(MailSender sender, Account account, String email, Texts texts) {
    String link =
        link(sender.baseUrl(), resets.issue(account, MAILED_LINK_LIFETIME, account.name()));
    try {
      sender.send(
          email,
          texts.get("forgotten.email.subject"),
          texts.get(
              "forgotten.email.text", account.name(), link, MAILED_LINK_LIFETIME.toMinutes()));
    } catch (IOException e) {
      LOG.warn("The password e-mail to {} was not sent: {}", account.name(), e.getMessage());
    }
  }

  /**
   * A link for a user to whom it is handed on. It ends those before it.
   *
   * @param baseUrl the address of these pages, without a slash at its end
   * @param manager the manager who makes it
   */
  public String createLink(Account user, String baseUrl, String manager) {
    resets.revoke(user);
    return link(
        mail == null ? baseUrl : mail.baseUrl(),
        resets.issue(user, CREATED_LINK_LIFETIME, manager));
  }

  public static Duration createdLinkLifetime() {
    return CREATED_LINK_LIFETIME;
  }

  /** The user whose password the link's secret replaces, while it is valid. */
  public Optional<Account> user(String secret) {
    return resets.account(secret);
  }

  /** False when the link is not valid any more: then nothing changes. */
  public boolean replacePassword(String secret, String passwordHash) {
    return resets.replacePassword(secret, passwordHash);
  }

  private static String link(String baseUrl, String secret) {
    return baseUrl + "/reset?secret=" + secret;
  }
}
