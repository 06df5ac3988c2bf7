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
import org.toqa.fleet.EventArchive.Filter;

class AccountsTest {
  private static final Instant START = Instant.parse("2026-11-21T08:00:00.123Z");

  private Instant now = START;
  private Jdbi jdbi;
  private Accounts accounts;
  private ApiTokens tokens;

  @BeforeEach
  void openEmptyDatabase() {
    String url =
        "jdbc:h2:mem:accounts-%d;MODE=MySQL;DATABASE_TO_LOWER=TRUE;CASE_INSENSITIVE_IDENTIFIERS=TRUE;DB_CLOSE_DELAY=-1"
            .formatted(System.nanoTime());
    Flyway.configure().dataSource(url, "sa", "").locations("classpath:sql").load().migrate();
    jdbi = Jdbi.create(url, "sa", "");
    accounts = new Accounts(jdbi, () -> now);
    tokens = new ApiTokens(jdbi, () -> now, Duration.ofHours(12));
  }

  @Test
  void namesAreUniqueWithoutRegardToCase() {
    Account added = accounts.add("Ada", "hash", Role.CLERK, "boss").orElseThrow();

    assertEquals(Optional.empty(), accounts.add("aDA", "other", Role.CLERK, "boss"));
    assertEquals(Optional.of(added), accounts.byName("ADA"));
    assertEquals(Optional.of(added), accounts.byId(added.id()));
    assertEquals(START, added.createdAt());
  }

  @Test
  void usersAreListedByName() {
    accounts.add("zoe", "hash", Role.CLERK, "boss");
    accounts.add("Bob", "hash", Role.MANAGER, "boss");
    accounts.add("ada", "hash", Role.CLERK, "boss");

    assertEquals(List.of("ada", "Bob", "zoe"), accounts.all().stream().map(Account::name).toList());
  }

  @Test
  void theFirstManagerIsAddedOnce() {
    accounts.add("clerk", "hash", Role.CLERK, "boss");
    assertFalse(accounts.hasManager());

    assertTrue(accounts.addFirstManager("boss", "hash").isPresent());
    assertTrue(accounts.hasManager());
    assertEquals(Optional.empty(), accounts.addFirstManager("thief", "hash"));
    assertEquals(Optional.empty(), accounts.byName("thief"));
  }

  @Test
  void theLastManagerStays() {
    long boss = accounts.add("boss", "hash", Role.MANAGER, "boss").orElseThrow().id();
    long second = accounts.add("second", "hash", Role.MANAGER, "boss").orElseThrow().id();

    assertEquals(Accounts.Outcome.DONE, accounts.delete(second, "boss"));
    assertEquals(Accounts.Outcome.LAST_MANAGER, accounts.delete(boss, "boss"));
    assertEquals(Accounts.Outcome.UNKNOWN, accounts.delete(second, "boss"));
    assertTrue(accounts.byId(boss).isPresent());
  }

  @Test
  void aTokenIsGoodUntilItExpires() {
    Account ada = accounts.add("ada", "hash", Role.CLERK, "boss").orElseThrow();
    String token = tokens.issue(ada.id());

    now = START.plus(Duration.ofHours(12)).minusMillis(1);
    assertEquals(Optional.of(ada), tokens.owner(token));
    assertEquals(Optional.empty(), tokens.owner(token + "x"));
    now = START.plus(Duration.ofHours(12));
    assertEquals(Optional.empty(), tokens.owner(token));
  }

  @Test
  void aNewPasswordEndsTheUsersTokens() {
    Account ada = accounts.add("ada", "hash", Role.CLERK, "boss").orElseThrow();
    String token = tokens.issue(ada.id());

    assertTrue(accounts.changePassword(ada.id(), "new hash", "boss"));

    assertEquals(Optional.empty(), tokens.owner(token));
    assertEquals("new hash", accounts.byId(ada.id()).orElseThrow().passwordHash());
    assertFalse(accounts.changePassword(ada.id() + 1, "new hash", "boss"));
  }

  @Test
  void theTokensOfADeletedUserEndWithHim() {
    Account ada = accounts.add("ada", "hash", Role.CLERK, "boss").orElseThrow();
    String token = tokens.issue(ada.id());

    accounts.delete(ada.id(), "boss");

    assertEquals(Optional.empty(), tokens.owner(token));
  }

  @Test
  void theLastManagerWhoMayLogInStaysOne() {
    long boss = accounts.add("boss", "hash", Role.MANAGER, "boss").orElseThrow().id();
    long second = accounts.add("second", "hash", Role.MANAGER, "boss").orElseThrow().id();

    assertEquals(Accounts.Outcome.DONE, accounts.change(second, Role.MANAGER, true, "boss"));
    assertEquals(Accounts.Outcome.LAST_MANAGER, accounts.change(boss, Role.CLERK, false, "boss"));
    assertEquals(Accounts.Outcome.LAST_MANAGER, accounts.change(boss, Role.MANAGER, true, "boss"));
    assertEquals(Accounts.Outcome.LAST_MANAGER, accounts.delete(boss, "boss"));
    assertEquals(Accounts.Outcome.DONE, accounts.delete(second, "boss"), "he may not log in");
    assertEquals(Accounts.Outcome.UNKNOWN, accounts.change(second, Role.CLERK, false, "boss"));
  }

  @Test
  void changesAreToldInTheHistory() {
    Account ada = accounts.add("ada", "hash", Role.CLERK, "boss").orElseThrow();
    accounts.change(ada.id(), Role.MANAGER, false, "boss");
    accounts.change(ada.id(), Role.MANAGER, false, "boss"); // changes nothing
    accounts.changePassword(ada.id(), "new hash", "ada");
    accounts.add("max", "hash", Role.MANAGER, "boss");
    accounts.delete(ada.id(), "max");

    assertEquals(
        List.of(
            "boss added the user ada",
            "boss made ada a manager",
            "ada changed the password of ada",
            "boss added the user max",
            "max deleted the user ada"),
        texts());
  }

  private List<String> texts() {
    return new JdbiEventArchive(jdbi)
        .events(new Filter(null, null, null, "user", null, null, true), Long.MAX_VALUE, 10).stream()
            .map(entry -> entry.event().text())
            .toList()
            .reversed();
  }

  @Test
  void theHashIsInNoLog() {
    Account ada = accounts.add("ada", "secret-hash", Role.CLERK, "boss").orElseThrow();

    assertFalse(ada.toString().contains("secret-hash"));
  }
}
