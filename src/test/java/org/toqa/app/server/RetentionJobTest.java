package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.store.Database;
import org.toqa.store.HistoryPruner;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What is deleted, by a wall clock and by the time that has really passed. */
class RetentionJobTest {
  private static final Instant START = Instant.parse("2026-11-21T10:00:00Z");
  private static final Duration YEAR = Duration.ofDays(365);

  private final Database database = MemoryDatabase.open("retention-" + System.nanoTime());
  private Instant wall = START;
  private long nanos;

  @AfterEach
  void close() {
    database.close();
  }

  @Test
  void aClockThatJumpsForwardDeletesNothingAndIsTold() {
    addEvent(START);
    try (RetentionJob job = job()) {
      wall = wall.plus(YEAR.multipliedBy(3));
      nanos += Duration.ofHours(1).toNanos();

      job.prune();

      assertEquals(1, events());
      assertEquals(Optional.of(Phrase.CLOCK_JUMPED.with(1094L)), job.warning()); // and 23 h

      wall = START.plus(Duration.ofHours(2));
      nanos += Duration.ofHours(1).toNanos();
      job.prune();
      assertEquals(Optional.empty(), job.warning());
      assertEquals(1, events());
    }
  }

  @Test
  void aServerThatStartsWithAWrongClockDeletesNothing() {
    addEvent(START);
    wall = START.plus(YEAR.multipliedBy(3));
    try (RetentionJob job = job()) {
      job.prune();

      assertEquals(1, events());
      assertEquals(Optional.of(Phrase.CLOCK_JUMPED.with(1095L)), job.warning());

      wall = START.plus(Duration.ofDays(10)); // the clock is set
      assertEquals(Optional.empty(), job.warning());
      job.prune();
      wall = wall.plus(YEAR.multipliedBy(3));
      job.prune();

      assertEquals(1, events());
      assertEquals(Optional.of(Phrase.CLOCK_JUMPED.with(1095L)), job.warning());
    }
  }

  @Test
  void whatIsOldIsDeletedAsTimePasses() {
    addEvent(START);
    try (RetentionJob job = job()) {
      for (int day = 0; day < 3 * 365; day++) {
        wall = wall.plus(Duration.ofDays(1));
        nanos += Duration.ofDays(1).toNanos();
      }
      job.prune();

      assertEquals(0, events());
      assertEquals(Optional.empty(), job.warning());
    }
  }

  @Test
  void aServerThatWasOffForAWeekDeletesWhatIsOld() {
    addEvent(START.minus(YEAR.multipliedBy(3)));
    addEvent(START.minus(Duration.ofDays(7)));
    try (RetentionJob job = job()) {
      job.prune();

      assertEquals(1, events());
    }
  }

  private RetentionJob job() {
    HistoryPruner pruner = new HistoryPruner(database.jdbi());
    return new RetentionJob(
        pruner,
        Duration.ofDays(90),
        Duration.ofDays(730),
        pruner.newestEvent(),
        () -> wall,
        () -> nanos);
  }

  private void addEvent(Instant at) {
    new JdbiFleetStore(database.jdbi())
        .addEvents(
            List.of(
                new EventRecord(
                    at,
                    EventKind.ROBOT_LOCATED,
                    null,
                    null,
                    "ann",
                    Sentence.verbatim("something of " + at))));
  }

  private long events() {
    return database
        .jdbi()
        .withHandle(
            handle -> handle.createQuery("select count(*) from events").mapTo(Long.class).one());
  }
}
