package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.accounts.AccountStore.ChangeResult.DONE;
import static org.toqa.accounts.AccountStore.ChangeResult.OUTDATED;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.flywaydb.core.Flyway;
import org.jdbi.v3.core.Jdbi;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Handover;
import org.toqa.accounts.PasswordResetStore;
import org.toqa.accounts.Role;
import org.toqa.accounts.Scope;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Session;
import org.toqa.accounts.Session.Carrier;
import org.toqa.accounts.Session.Kind;
import org.toqa.accounts.SessionStore;
import org.toqa.accounts.Site;
import org.toqa.fleet.history.EventArchive.Filter;

class AccountStoreTest {
  private static final Site SITE = new Site(Site.FIRST_ID, "main");
  private static final Instant START = Instant.parse("2026-11-21T08:00:00.123Z");

  private static final Session.Origin ORIGIN = new Session.Origin("10.0.0.7", "a browser");

  private Instant now = START;
  private static final Duration LIMIT = Duration.ofDays(7);
  private static final int PER_USER = 3;

  private Jdbi jdbi;
  private AccountStore accounts;
  private SessionStore sessions;
  private PasswordResetStore resets;

  @BeforeEach
  void openEmptyDatabase() {
    String url =
        "jdbc:h2:mem:accounts-%d;MODE=MySQL;DATABASE_TO_LOWER=TRUE;CASE_INSENSITIVE_IDENTIFIERS=TRUE;DB_CLOSE_DELAY=-1"
            .formatted(System.nanoTime());
    Flyway.configure().dataSource(url, "sa", "").locations("classpath:sql").load().migrate();
    jdbi = Jdbi.create(url, "sa", "");
    DatabaseTypes.register(jdbi);
    LastKnownUsers lastKnown = new LastKnownUsers();
    accounts = new JdbiAccountStore(jdbi, () -> now, lastKnown);
    sessions = new JdbiSessionStore(jdbi, () -> now, LIMIT, PER_USER, SITE, lastKnown);
    resets = new JdbiPasswordResetStore(jdbi, () -> now, SITE, lastKnown);
  }

  @Test
  void ofMoreLoginsThanAUserMayHaveTheLeastUsedEnds() {
    Account ada = accounts.add("Ada", "hash", Role.CLERK, "boss").orElseThrow();
    String first = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    now = now.plus(Duration.ofMinutes(5));
    String second = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    now = now.plus(Duration.ofMinutes(5));
    String program = sessions.begin(ada, Kind.API, ORIGIN).secret();
    String third = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    now = now.plus(Duration.ofMinutes(5));
    assertTrue(sessions.authenticate(Carrier.COOKIE, first).isPresent());

    String fourth = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();

    assertTrue(sessions.authenticate(Carrier.COOKIE, second).isEmpty(), "the least used");
    for (String kept : List.of(first, third, fourth)) {
      assertTrue(sessions.authenticate(Carrier.COOKIE, kept).isPresent());
    }
    assertTrue(sessions.authenticate(Carrier.BEARER, program).isPresent(), "another kind");
  }

  @Test
  void aUserHasSoManyTokensAndNoneEndsByItself() {
    Account ada = accounts.add("Ada", "hash", Role.CLERK, "boss").orElseThrow();
    for (int i = 0; i < PER_USER; i++) {
      assertTrue(sessions.mayIssueToken(ada.id()));
      sessions.issueToken(ada, "ci " + i, Set.of(Scope.READ), ORIGIN, Duration.ofDays(2));
    }

    assertFalse(sessions.mayIssueToken(ada.id()));
    now = now.plus(Duration.ofDays(3));
    assertTrue(sessions.mayIssueToken(ada.id()), "they have expired");
  }

  @Test
  void namesAreUniqueWithoutRegardToCase() {
    Account added = accounts.add("Ada", "hash", Role.CLERK, "boss").orElseThrow();

    assertEquals(Optional.empty(), accounts.add("aDA", "other", Role.CLERK, "boss"));
    assertEquals(Optional.of(added), accounts.accountByName("ADA"));
    assertEquals(Optional.of(added), accounts.account(added.id()));
    assertEquals(START, added.createdAt());
  }

  @ParameterizedTest
  @EnumSource(Role.class)
  void everyRoleIsKept(Role role) {
    Account boss = accounts.add("Boss", "hash", Role.ADMINISTRATOR, "boss").orElseThrow();
    Account ada = accounts.add("Ada", "hash", Role.CLERK, "boss").orElseThrow();

    accounts.update(ada.id(), role, false, null, boss.name());

    assertEquals(role, accounts.account(ada.id()).orElseThrow().role());
  }

  @Test
  void usersAreListedByName() {
    accounts.add("zoe", "hash", Role.CLERK, "boss");
    accounts.add("Bob", "hash", Role.MANAGER, "boss");
    accounts.add("ada", "hash", Role.CLERK, "boss");

    assertEquals(
        List.of("ada", "Bob", "zoe"), accounts.accounts().stream().map(Account::name).toList());
  }

  @Test
  void theFirstManagerIsAddedOnce() {
    accounts.add("clerk", "hash", Role.CLERK, "boss");
    assertFalse(accounts.hasManager());

    assertTrue(accounts.addFirstManager("boss", "hash").isPresent());
    assertTrue(accounts.hasManager());
    assertEquals(Optional.empty(), accounts.addFirstManager("thief", "hash"));
    assertEquals(Optional.empty(), accounts.accountByName("thief"));
  }

  @Test
  void theLastManagerStays() {
    long boss = accounts.add("boss", "hash", Role.MANAGER, "boss").orElseThrow().id();
    long second = accounts.add("second", "hash", Role.MANAGER, "boss").orElseThrow().id();

    assertEquals(AccountStore.ChangeResult.DONE, accounts.delete(second, "boss"));
    assertEquals(AccountStore.ChangeResult.LAST_MANAGER, accounts.delete(boss, "boss"));
    assertEquals(AccountStore.ChangeResult.NO_SUCH_ACCOUNT, accounts.delete(second, "boss"));
    assertTrue(accounts.account(boss).isPresent());
  }

  @Test
  void aTokenIsGoodUntilItExpires() {
    Account ada = ada();
    SessionStore.NewSession begun =
        sessions.issueToken(ada, "ci", Set.of(Scope.READ), ORIGIN, Duration.ofDays(2));

    now = START.plus(Duration.ofDays(2)).minusMillis(1);
    assertEquals(Optional.of(ada), owner(Carrier.BEARER, begun.secret()));
    assertEquals(Optional.empty(), owner(Carrier.BEARER, begun.secret() + "x"));
    assertEquals(Optional.empty(), owner(Carrier.COOKIE, begun.secret()), "used as another kind");
    now = START.plus(Duration.ofDays(2));
    assertEquals(Optional.empty(), owner(Carrier.BEARER, begun.secret()));
    assertEquals(List.of(), sessions.sessions(ada.id()));
  }

  @Test
  void whoLogsInByAClockThatIsAheadEndsNobodysLogin() {
    Account ada = ada();
    String browser = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    String token =
        sessions.issueToken(ada, "ci", Set.of(Scope.READ), ORIGIN, Duration.ofDays(2)).secret();
    String link = resets.issue(ada, Duration.ofHours(1), "ada");

    now = START.plus(Duration.ofDays(1000));
    assertEquals(Optional.empty(), owner(Carrier.COOKIE, browser));
    sessions.begin(ada, Kind.BROWSER, ORIGIN);
    sessions.issueToken(ada, "cd", Set.of(Scope.READ), ORIGIN, Duration.ofDays(2));
    resets.issue(ada, Duration.ofHours(1), "ada");
    now = START.plusSeconds(60); // it is set

    assertEquals(Optional.of(ada), owner(Carrier.COOKIE, browser));
    assertEquals(Optional.of(ada), owner(Carrier.BEARER, token));
    assertEquals(Optional.of(ada), resets.account(link));
  }

  @Test
  void ofTooManyLoginsThoseThatHaveExpiredGoFirst() {
    Account ada = ada();
    String live = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    now = START.plusSeconds(1);
    for (int i = 1; i < PER_USER; i++) {
      String expired = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
      jdbi.useHandle(
          h ->
              h.execute(
                  "update sessions set expires_at = ? where secret_hash = ?",
                  now,
                  Secret.hash(expired)));
    }
    now = START.plusSeconds(2);

    sessions.begin(ada, Kind.BROWSER, ORIGIN);

    assertEquals(Optional.of(ada), owner(Carrier.COOKIE, live), "though it is the least used");
  }

  @Test
  void whatHasExpiredLongAgoIsRemoved() {
    Account ada = ada();
    sessions.begin(ada, Kind.BROWSER, ORIGIN);
    resets.issue(ada, Duration.ofHours(1), "ada");
    String token =
        sessions.issueToken(ada, "ci", Set.of(Scope.READ), ORIGIN, Duration.ofDays(2)).secret();

    new HistoryPruner(jdbi).pruneExpired(START.plus(Duration.ofDays(1)));

    assertEquals(Optional.of(ada), owner(Carrier.BEARER, token));
    assertEquals(1, count("sessions"));
    assertEquals(0, count("reset_links"));
  }

  private int count(String table) {
    return jdbi.withHandle(
        h -> h.createQuery("select count(*) from " + table).mapTo(Integer.class).one());
  }

  @Test
  void aBrowsersSessionEndsTwelveHoursAfterItsLastUse() {
    Account ada = ada();
    String secret = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();

    now = START.plus(Duration.ofHours(11));
    assertEquals(Optional.of(ada), owner(Carrier.COOKIE, secret));
    now = START.plus(Duration.ofHours(22));
    assertEquals(Optional.of(ada), owner(Carrier.COOKIE, secret), "11 h after the last use");
    assertEquals(now, sessions.sessions(ada.id()).getFirst().seenAt());
    now = START.plus(Duration.ofHours(34));
    assertEquals(Optional.empty(), owner(Carrier.COOKIE, secret));
  }

  @Test
  void aProgramsSessionEndsAnHourAfterItsLastUse() {
    Account ada = ada();
    String secret = sessions.begin(ada, Kind.API, ORIGIN).secret();

    now = START.plus(Duration.ofMinutes(59));
    assertEquals(Optional.of(ada), owner(Carrier.BEARER, secret));
    now = START.plus(Duration.ofMinutes(118));
    assertEquals(Optional.of(ada), owner(Carrier.BEARER, secret), "59 min after the last use");
    now = START.plus(Duration.ofMinutes(178));
    assertEquals(Optional.empty(), owner(Carrier.BEARER, secret));
  }

  @Test
  void whatIsNoUsePutsNoEndOff() {
    Account ada = ada();
    String secret = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();

    for (int hour = 1; hour < 12; hour++) {
      now = START.plus(Duration.ofHours(hour));
      assertTrue(sessions.find(Carrier.COOKIE, secret).isPresent(), hour + " h");
    }
    now = START.plus(Duration.ofHours(12));
    assertEquals(Optional.empty(), sessions.find(Carrier.COOKIE, secret));
  }

  @Test
  void aSessionInUseEndsForGoodAtTheLimit() {
    Account ada = ada();
    String browser = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    String token =
        sessions.issueToken(ada, "ci", Set.of(Scope.TASKS), ORIGIN, Duration.ofDays(90)).secret();

    for (now = START; now.isBefore(START.plus(LIMIT)); now = now.plus(Duration.ofHours(6))) {
      assertTrue(sessions.authenticate(Carrier.COOKIE, browser).isPresent(), "at " + now);
    }
    now = START.plus(LIMIT);
    assertEquals(Optional.empty(), owner(Carrier.COOKIE, browser));
    assertEquals(
        Set.of(Scope.TASKS),
        sessions.authenticate(Carrier.BEARER, token).orElseThrow().session().scopes());
    // a shorter limit holds for what began before it too
    SessionStore shorter =
        new JdbiSessionStore(
            jdbi, () -> now, Duration.ofHours(1), PER_USER, SITE, new LastKnownUsers());
    String second = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    now = now.plus(Duration.ofHours(2));
    assertTrue(sessions.find(Carrier.COOKIE, second).isPresent());
    assertEquals(Optional.empty(), shorter.find(Carrier.COOKIE, second));
  }

  @Test
  void whoGetsSchedulesAndTokensOfADeletedUserIsSaid() {
    Account ada = ada();
    Account bob = accounts.add("bob", "hash", Role.CLERK, "boss").orElseThrow();
    String token =
        sessions.issueToken(ada, "ci", Set.of(Scope.READ), ORIGIN, Duration.ofDays(2)).secret();
    String browser = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();

    accounts.delete(ada.id(), new Handover(bob, bob), "boss");

    assertEquals(Optional.of(bob), owner(Carrier.BEARER, token));
    assertEquals(Optional.empty(), owner(Carrier.COOKIE, browser));
    assertTrue(texts().contains("boss handed API token ci of ada over to bob"), texts().toString());
  }

  @Test
  void aSessionIsEndedByItsUserOnly() {
    Account ada = ada();
    Account bob = accounts.add("bob", "hash", Role.CLERK, "boss").orElseThrow();
    SessionStore.NewSession begun = sessions.begin(ada, Kind.BROWSER, ORIGIN);

    assertFalse(sessions.end(bob, begun.session().id(), "bob"));
    assertEquals(List.of(begun.session()), sessions.sessions(ada.id()));
    assertTrue(sessions.end(ada, begun.session().id(), "boss"));
    assertEquals(Optional.empty(), owner(Carrier.COOKIE, begun.secret()));
    assertFalse(begun.toString().contains(begun.secret()), "it reaches no log");
  }

  @Test
  void aNewPasswordEndsTheUsersSessionsTokensAndLinks() {
    Account ada = ada();
    String browser = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    String token =
        sessions.issueToken(ada, "ci", Set.of(Scope.READ), ORIGIN, Duration.ofDays(2)).secret();
    String link = resets.issue(ada, Duration.ofHours(1), "ada");

    assertTrue(accounts.changePassword(ada.id(), "new hash", "boss"));

    assertEquals(Optional.empty(), owner(Carrier.COOKIE, browser));
    assertEquals(Optional.empty(), owner(Carrier.BEARER, token));
    assertEquals(Optional.empty(), resets.account(link));
    assertEquals("new hash", accounts.account(ada.id()).orElseThrow().passwordHash());
    assertFalse(accounts.changePassword(ada.id() + 1, "new hash", "boss"));
  }

  @Test
  void theSessionsOfADeletedUserEndWithHim() {
    Account ada = ada();
    String token = sessions.begin(ada, Kind.API, ORIGIN).secret();
    String link = resets.issue(ada, Duration.ofHours(1), "boss");

    accounts.delete(ada.id(), "boss");

    assertEquals(Optional.empty(), owner(Carrier.BEARER, token));
    assertFalse(resets.replacePassword(link, "new hash"));
  }

  @Test
  void aLinkReplacesAPasswordOnce() {
    Account ada = ada();
    String browser = sessions.begin(ada, Kind.BROWSER, ORIGIN).secret();
    String first = resets.issue(ada, Duration.ofHours(1), "ada");
    String second = resets.issue(ada, Duration.ofHours(1), "ada");

    assertEquals(Optional.of(ada), resets.account(first), "who asks again ends none");
    assertEquals(Optional.of(ada), resets.account(second));
    assertTrue(resets.replacePassword(second, "new hash"));
    assertFalse(resets.replacePassword(first, "newer hash"), "the one that is used ends all");
    assertFalse(resets.replacePassword(second, "newer hash"));
    assertEquals("new hash", accounts.account(ada.id()).orElseThrow().passwordHash());
    assertEquals(Optional.empty(), owner(Carrier.COOKIE, browser));
  }

  @Test
  void aLinkIsGoodForItsTime() {
    String link = resets.issue(ada(), Duration.ofHours(1), "ada");

    now = START.plus(Duration.ofHours(1)).minusMillis(1);
    assertTrue(resets.account(link).isPresent());
    now = START.plus(Duration.ofHours(1));
    assertEquals(Optional.empty(), resets.account(link));
    assertFalse(resets.replacePassword(link, "new hash"));
  }

  @Test
  void whoeverForgotIsFoundByNameOrElseByEmail() {
    Account ada =
        accounts.add("ada", "Shared@example.org", "hash", Role.CLERK, "boss").orElseThrow();
    Account bob =
        accounts.add("bob", "shared@example.org", "hash", Role.CLERK, "boss").orElseThrow();

    assertEquals(List.of(ada), accounts.accountsByNameOrEmail("ADA"));
    assertEquals(List.of(ada, bob), accounts.accountsByNameOrEmail("SHARED@example.org"));
    assertEquals(List.of(), accounts.accountsByNameOrEmail("nobody@example.org"));
  }

  @Test
  void aNewEmailAddressEndsTheLinkThatWentToTheOldOne() {
    Account ada = ada();
    String link = resets.issue(ada, Duration.ofHours(1), "ada");

    assertEquals(DONE, accounts.changeEmail(ada.id(), "ada@example.org", null, "ada"));
    assertEquals(Optional.empty(), resets.account(link));
    assertEquals("ada@example.org", accounts.account(ada.id()).orElseThrow().email());
    assertEquals(DONE, accounts.changeEmail(ada.id(), null, null, "boss"));
    assertEquals(
        AccountStore.ChangeResult.NO_SUCH_ACCOUNT,
        accounts.changeEmail(ada.id() + 1, null, null, "boss"));
  }

  @Test
  void whatAnotherHasChangedSinceItWasReadIsNotOverwritten() {
    Account read = ada();
    assertEquals(DONE, accounts.update(read.id(), Role.CLERK, true, read, "boss"));

    assertEquals(OUTDATED, accounts.update(read.id(), Role.MANAGER, false, read, "max"));
    assertEquals(OUTDATED, accounts.changeEmail(read.id(), "ada@example.org", read, "max"));

    Account disabled = accounts.account(read.id()).orElseThrow();
    assertTrue(disabled.disabled());
    assertEquals(Role.CLERK, disabled.role());
    assertNull(disabled.email());
    assertEquals(DONE, accounts.changeEmail(read.id(), "ada@example.org", disabled, "boss"));
    assertEquals(OUTDATED, accounts.update(read.id(), Role.CLERK, false, disabled, "max"));
    Account now = accounts.account(read.id()).orElseThrow();
    assertEquals(DONE, accounts.update(read.id(), Role.CLERK, false, now, "boss"));
  }

  private Account ada() {
    return accounts.add("ada", "hash", Role.CLERK, "boss").orElseThrow();
  }

  private Optional<Account> owner(Carrier carrier, String secret) {
    return sessions.authenticate(carrier, secret).map(SessionStore.AuthenticatedSession::account);
  }

  @Test
  void theLastManagerWhoMayLogInStaysOne() {
    long boss = accounts.add("boss", "hash", Role.MANAGER, "boss").orElseThrow().id();
    long second = accounts.add("second", "hash", Role.MANAGER, "boss").orElseThrow().id();
    assertTrue(accounts.add("keeper", "hash", Role.OPERATOR, "boss").isPresent());
    assertTrue(accounts.add("guest", "hash", Role.VIEWER, "boss").isPresent());

    assertEquals(
        AccountStore.ChangeResult.DONE, accounts.update(second, Role.MANAGER, true, "boss"));
    assertEquals(
        AccountStore.ChangeResult.LAST_MANAGER, accounts.update(boss, Role.CLERK, false, "boss"));
    assertEquals(
        AccountStore.ChangeResult.LAST_MANAGER, accounts.update(boss, Role.MANAGER, true, "boss"));
    assertEquals(AccountStore.ChangeResult.LAST_MANAGER, accounts.delete(boss, "boss"));
    assertEquals(
        AccountStore.ChangeResult.DONE, accounts.delete(second, "boss"), "he may not log in");
    assertEquals(
        AccountStore.ChangeResult.NO_SUCH_ACCOUNT,
        accounts.update(second, Role.CLERK, false, "boss"));
  }

  @Test
  void changesAreToldInTheHistory() {
    Account ada = accounts.add("ada", "hash", Role.CLERK, "boss").orElseThrow();
    accounts.update(ada.id(), Role.MANAGER, false, "boss");
    accounts.update(ada.id(), Role.MANAGER, false, "boss"); // changes nothing
    accounts.changePassword(ada.id(), "new hash", "ada");
    accounts.add("max", "hash", Role.MANAGER, "boss");
    accounts.delete(ada.id(), "max");

    assertEquals(
        List.of(
            "boss added user ada",
            "boss made ada a manager",
            "ada changed the password of ada",
            "boss added user max",
            "max deleted user ada"),
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
