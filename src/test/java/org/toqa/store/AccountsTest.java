package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.flywaydb.core.Flyway;
import org.jdbi.v3.core.Jdbi;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class AccountsTest {
  private static final Instant START = Instant.parse("2026-11-21T08:00:00.123Z");

  private Instant now = START;
  private Accounts accounts;
  private ApiTokens tokens;

  @BeforeEach
  void openEmptyDatabase() {
    String url =
        "jdbc:h2:mem:accounts-%d;MODE=MySQL;DATABASE_TO_LOWER=TRUE;CASE_INSENSITIVE_IDENTIFIERS=TRUE;DB_CLOSE_DELAY=-1"
            .formatted(System.nanoTime());
    Flyway.configure().dataSource(url, "sa", "").locations("classpath:sql").load().migrate();
    Jdbi jdbi = Jdbi.create(url, "sa", "");
    accounts = new Accounts(jdbi, () -> now);
    tokens = new ApiTokens(jdbi, () -> now, Duration.ofHours(12));
  }

  @Test
  void namesAreUniqueWithoutRegardToCase() {
    Account added = accounts.add("Ada", "hash", Role.CLERK).orElseThrow();

    assertEquals(Optional.empty(), accounts.add("aDA", "other", Role.CLERK));
    assertEquals(Optional.of(added), accounts.byName("ADA"));
    assertEquals(Optional.of(added), accounts.byId(added.id()));
    assertEquals(START, added.createdAt());
  }

  @Test
  void usersAreListedByName() {
    accounts.add("zoe", "hash", Role.CLERK);
    accounts.add("Bob", "hash", Role.MANAGER);
    accounts.add("ada", "hash", Role.CLERK);

    assertEquals(List.of("ada", "Bob", "zoe"), accounts.all().stream().map(Account::name).toList());
  }

  @Test
  void theFirstManagerIsAddedOnce() {
    accounts.add("clerk", "hash", Role.CLERK);
    assertFalse(accounts.hasManager());

    assertTrue(accounts.addFirstManager("boss", "hash").isPresent());
    assertTrue(accounts.hasManager());
    assertEquals(Optional.empty(), accounts.addFirstManager("thief", "hash"));
    assertEquals(Optional.empty(), accounts.byName("thief"));
  }

  @Test
  void theLastManagerStays() {
    long boss = accounts.add("boss", "hash", Role.MANAGER).orElseThrow().id();
    long second = accounts.add("second", "hash", Role.MANAGER).orElseThrow().id();

    assertEquals(Accounts.Deletion.DELETED, accounts.delete(second));
    assertEquals(Accounts.Deletion.LAST_MANAGER, accounts.delete(boss));
    assertEquals(Accounts.Deletion.UNKNOWN, accounts.delete(second));
    assertTrue(accounts.byId(boss).isPresent());
  }

  @Test
  void aTokenIsGoodUntilItExpires() {
    Account ada = accounts.add("ada", "hash", Role.CLERK).orElseThrow();
    String token = tokens.issue(ada.id());

    now = START.plus(Duration.ofHours(12)).minusMillis(1);
    assertEquals(Optional.of(ada), tokens.owner(token));
    assertEquals(Optional.empty(), tokens.owner(token + "x"));
    now = START.plus(Duration.ofHours(12));
    assertEquals(Optional.empty(), tokens.owner(token));
  }

  @Test
  void aNewPasswordEndsTheUsersTokens() {
    Account ada = accounts.add("ada", "hash", Role.CLERK).orElseThrow();
    String token = tokens.issue(ada.id());

    assertTrue(accounts.changePassword(ada.id(), "new hash"));

    assertEquals(Optional.empty(), tokens.owner(token));
    assertEquals("new hash", accounts.byId(ada.id()).orElseThrow().passwordHash());
    assertFalse(accounts.changePassword(ada.id() + 1, "new hash"));
  }

  @Test
  void theTokensOfADeletedUserEndWithHim() {
    Account ada = accounts.add("ada", "hash", Role.CLERK).orElseThrow();
    String token = tokens.issue(ada.id());

    accounts.delete(ada.id());

    assertEquals(Optional.empty(), tokens.owner(token));
  }

  @Test
  void theHashIsInNoLog() {
    Account ada = accounts.add("ada", "secret-hash", Role.CLERK).orElseThrow();

    assertFalse(ada.toString().contains("secret-hash"));
  }
}
