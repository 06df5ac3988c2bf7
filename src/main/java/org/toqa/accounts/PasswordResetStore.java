package org.toqa.accounts;

import java.time.Duration;
import java.util.Optional;

/**
 * Secrets by which a forgotten password is replaced, each once and for a while. A new one ends none
 * before it, or whoever asks for one could take another's away; the one that is used ends all.
 *
 * <p>Any thread may call it and may have to wait. Every method throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer.
 */
public interface PasswordResetStore {

  /**
   * A new secret for that account.
   *
   * @param lifetime how long it is valid from now on, in real time
   * @param by who asked for it, as the history tells
   */
  String issue(Account account, Duration lifetime, String by);

  /** Ends all secrets of that account. */
  void revoke(Account account);

  /** The account whose password the secret replaces, while it is good. */
  Optional<Account> account(String secret);

  /**
   * Replaces the password of the secret's account, once.
   *
   * @return false when the secret is not good, or not any more: then nothing changes
   */
  boolean replacePassword(String secret, String passwordHash);
}
