package org.toqa.accounts;

import com.password4j.Argon2Function;
import com.password4j.Password;
import com.password4j.types.Argon2;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Semaphore;
import java.util.regex.Pattern;

/**
 * Passwords as Argon2id hashes (RFC 9106) with 19 MiB, two passes and one lane: the first choice of
 * the OWASP password storage cheat sheet. At most as many are computed at a time as there are
 * processors, so that a flood of logins takes neither all memory nor all time.
 */
public final class PasswordHasher {
  private static final int MEMORY_KIB = 19_456;
  private static final int PASSES = 2;
  private static final int LANES = 1;
  private static final int HASH_BYTES = 32;
  private static final int SALT_BYTES = 16;

  /** Of a random password that nobody knows; what a check of it costs is what a check costs. */
  static final String NOBODYS_HASH =
      "$argon2id$v=19$m=19456,t=2,p=1$Iv19/krwM0CNJrGM/TwaFQ"
          + "$z2iSIybp/nTxiMlXkoOmKpLVXKhSf2AwBoGsN6mroeo";

  private static final Pattern HASH =
      Pattern.compile(
          "\\$argon2id\\$v=19\\$m=\\d{2,7},t=\\d{1,2},p=\\d{1,2}"
              + "\\$[A-Za-z0-9+/]{11,}\\$[A-Za-z0-9+/]{22,}");

  private final Argon2Function argon2;
  private final String nobodysHash;
  private final Semaphore permits = new Semaphore(Runtime.getRuntime().availableProcessors());

  public PasswordHasher() {
    argon2 = argon2(MEMORY_KIB, PASSES);
    nobodysHash = NOBODYS_HASH;
  }

  /**
   * Of another cost than the recommended one.
   *
   * @param memoryKib kibibytes, at least 8
   */
  public PasswordHasher(int memoryKib, int passes) {
    argon2 = argon2(memoryKib, passes);
    nobodysHash = hash(UUID.randomUUID().toString());
  }

  private static Argon2Function argon2(int memoryKib, int passes) {
    return Argon2Function.getInstance(memoryKib, passes, LANES, HASH_BYTES, Argon2.ID);
  }

  /** Whether the text is no password, but the hash of one, as {@link #hash} writes it. */
  public static boolean isHash(String text) {
    return HASH.matcher(text).matches();
  }

  public String hash(String password) {
    permits.acquireUninterruptibly();
    try {
      return Password.hash(password).addRandomSalt(SALT_BYTES).with(argon2).getResult();
    } finally {
      permits.release();
    }
  }

  /** Takes as long for nobody as for somebody, so that names cannot be found out by the time. */
  public boolean isCorrect(String password, Optional<Account> account) {
    String hash = account.map(Account::passwordHash).orElse(nobodysHash);
    permits.acquireUninterruptibly();
    try {
      boolean same = Password.check(password, hash).with(Argon2Function.getInstanceFromHash(hash));
      return same && account.isPresent();
    } finally {
      permits.release();
    }
  }
}
