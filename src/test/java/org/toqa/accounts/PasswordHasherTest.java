package org.toqa.accounts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class PasswordHasherTest {
  private final PasswordHasher passwords = new PasswordHasher();

  @Test
  void hashCostsWhatIsRecommended() {
    assertEquals("$argon2id$v=19$m=19456,t=2,p=1", cost(passwords.hash("a password")));
    assertEquals(43, passwords.hash("a password").replaceFirst(".*\\$", "").length()); // 32 bytes
  }

  @Test
  void everyHashHasASaltOfItsOwn() {
    assertNotEquals(passwords.hash("a password"), passwords.hash("a password"));
  }

  @Test
  void checkForNobodyCostsAsMuchAndFails() {
    assertEquals(cost(passwords.hash("a password")), cost(PasswordHasher.NOBODYS_HASH));
    assertEquals(passwords.hash("a password").length(), PasswordHasher.NOBODYS_HASH.length());
    assertFalse(passwords.isCorrect("a password", Optional.empty()));
  }

  /** All but salt and hash. */
  private static String cost(String hash) {
    return hash.replaceFirst("\\$[^$]+\\$[^$]+$", "");
  }
}
