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
import org.toqa.accounts.Session;
import org.toqa.accounts.Site;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.persistence.StoreException;

/** Who asks the database has connections of his own, and a time limit. */
@Timeout(60)
class DatabasePoolsTest extends FleetDatabaseTest {
  private final List<Handle> held = new ArrayList<>();

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

  private JdbiSessionStore sessions() {
    return new JdbiSessionStore(
        database.sessions(),
        InstantSource.system(),
        Duration.ofDays(1),
        50,
        new Site(Site.FIRST_ID, "main"));
  }
}
