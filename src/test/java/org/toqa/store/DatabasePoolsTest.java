package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.jdbi.v3.core.ConnectionException;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.accounts.Session;
import org.toqa.accounts.SessionStore.NewSession;
import org.toqa.accounts.Site;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.persistence.StoreException;

/** Who asks the database has connections of his own, and a time limit. */
@Timeout(60)
class DatabasePoolsTest extends FleetDatabaseTest {
  private static final Site SITE = new Site(Site.FIRST_ID, "main");
  private static final Session.Origin ORIGIN = new Session.Origin("10.0.0.7", "a browser");

  private final List<Handle> held = new ArrayList<>();
  private final LastKnownUsers lastKnown = new LastKnownUsers();

  @Override
  Database open() {
    return MemoryDatabase.open("pools-" + System.nanoTime(), Duration.ofMillis(200));
  }

  @AfterEach
  void giveBack() {
    held.forEach(Handle::close);
  }

  @Test
  void readersHoldNoConnectionOfTheFleetOrOfSessions() {
    holdAll(database.readers());

    store.checkAvailable();
    assertEquals(Optional.empty(), sessions().authenticate(Session.Carrier.BEARER, "invented"));
  }

  @Test
  void thoseWhoAreAskedWhoTheyAreHoldNoneOfTheFleet() {
    holdAll(database.sessions());

    store.checkAvailable();
    database.readers().useHandle(handle -> handle.execute("select 1"));
  }

  @Test
  void aStatementOfAReaderThatTakesTooLongIsEnded() {
    SqlExecutor readers = new SqlExecutor(database.readers());

    StoreException failure =
        assertThrows(
            StoreException.class,
            () ->
                readers.withHandle(
                    handle ->
                        handle
                            .createQuery(
                                "select count(*) from system_range(1, 20000) a,"
                                    + " system_range(1, 5000) b where a.x + b.x = 0")
                            .mapTo(Long.class)
                            .one()));

    assertEquals(StoreException.Kind.TOO_SLOW, failure.kind());
  }

  @Test
  void aTextThatIsTooLongIsRefusedForEver() {
    StoreException name =
        assertThrows(StoreException.class, () -> added(task("too long ".repeat(100))));
    assertTrue(name.isRefusal());
  }

  @Test
  void aDatabaseThatIsAwayRefusesNothing() {
    database.close();

    StoreException away = assertThrows(StoreException.class, store::checkAvailable);

    assertFalse(away.isRefusal());
    openDatabaseAgain();
  }

  @Test
  void whoIsLoggedInIsKnownWhileTheDatabaseIsAway() {
    JdbiSessionStore sessions = sessions();
    Account user = accounts().add("ada", "hash", Role.CLERK, "boss").orElseThrow();
    NewSession login = sessions.begin(user, Session.Kind.BROWSER, ORIGIN);
    assertEquals("ada", owner(sessions, login.secret()).orElseThrow());

    database.close();

    assertEquals("ada", owner(sessions, login.secret()).orElseThrow());
    openDatabaseAgain();
  }

  /** Each of these ends what was known of him. */
  private enum End {
    LOGIN_ENDED {
      @Override
      void apply(DatabasePoolsTest test, Account user, NewSession login) {
        assertTrue(test.sessions().end(user, login.session().id(), "boss"));
      }
    },
    LOGGED_OUT {
      @Override
      void apply(DatabasePoolsTest test, Account user, NewSession login) {
        test.sessions().end(login.secret());
      }
    },
    DISABLED {
      @Override
      void apply(DatabasePoolsTest test, Account user, NewSession login) {
        assertEquals(
            AccountStore.ChangeResult.DONE,
            test.accounts().update(user.id(), Role.CLERK, true, null, "boss"));
      }
    },
    PASSWORD_CHANGED {
      @Override
      void apply(DatabasePoolsTest test, Account user, NewSession login) {
        assertTrue(test.accounts().changePassword(user.id(), "another", "boss"));
      }
    },
    PASSWORD_REPLACED {
      @Override
      void apply(DatabasePoolsTest test, Account user, NewSession login) {
        JdbiPasswordResetStore resets =
            new JdbiPasswordResetStore(
                test.database.sessions(), InstantSource.system(), SITE, test.lastKnown);
        String link = resets.issue(user, Duration.ofHours(1), "boss");
        assertTrue(resets.replacePassword(link, "another"));
      }
    };

    abstract void apply(DatabasePoolsTest test, Account user, NewSession login);
  }

  @ParameterizedTest
  @EnumSource
  void whoseLoginWasEndedIsUnknownWhileTheDatabaseIsAway(End end) {
    JdbiSessionStore sessions = sessions();
    Account user = accounts().add("ada", "hash", Role.CLERK, "boss").orElseThrow();
    NewSession login = sessions.begin(user, Session.Kind.BROWSER, ORIGIN);
    assertEquals("ada", owner(sessions, login.secret()).orElseThrow());

    end.apply(this, user, login);
    database.close();

    assertThrows(StoreException.class, () -> owner(sessions, login.secret()));
    openDatabaseAgain();
  }

  private static Optional<String> owner(JdbiSessionStore sessions, String secret) {
    return sessions
        .authenticate(Session.Carrier.COOKIE, secret)
        .map(login -> login.account().name());
  }

  @Test
  void aMissingTableMayComeBack() {
    database.jdbi().useHandle(handle -> handle.execute("drop table drives"));

    StoreException missing = assertThrows(StoreException.class, () -> store.drive("r1"));

    assertEquals(StoreException.Kind.UNAVAILABLE, missing.kind());
  }

  @Test
  void whatSomebodyElseHasStoredMeanwhileIsFoundByWhoAsksAgain() {
    UUID key = UUID.randomUUID();
    store.addTasks(List.of(new Submission(task("crate"), key)));

    StoreException again =
        assertThrows(
            StoreException.class,
            () -> store.addTasks(List.of(new Submission(task("crate"), key))));

    assertEquals(StoreException.Kind.OVERTAKEN, again.kind());
  }

  private void openDatabaseAgain() {
    database = open();
  }

  /** Takes connections until there are no more. */
  private void holdAll(Jdbi jdbi) {
    try {
      while (true) {
        held.add(jdbi.open());
        assertTrue(held.size() < 100, "there is no limit");
      }
    } catch (ConnectionException none) {
      assertFalse(held.isEmpty());
    }
  }

  private JdbiAccountStore accounts() {
    return new JdbiAccountStore(database.sessions(), InstantSource.system(), lastKnown);
  }

  private JdbiSessionStore sessions() {
    return new JdbiSessionStore(
        database.sessions(), InstantSource.system(), Duration.ofDays(1), 50, SITE, lastKnown);
  }
}
