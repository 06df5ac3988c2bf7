package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.sql.SQLException;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.UUID;
import java.util.function.ToLongFunction;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotUse;
import org.toqa.fleet.UseRecord;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/** What a period is in numbers; here on H2, in {@code MySqlStatisticsTest} on MySQL. */
class StatisticsTest {
  private static final ZoneId UTC = ZoneId.of("UTC");
  private static final ZoneId PARIS = ZoneId.of("Europe/Paris");
  private static final LocalDate DAY = LocalDate.of(2026, 11, 20);
  private static final Instant NOON = Instant.parse("2026-11-20T12:00:00Z");

  private Database database;
  private JdbiFleetStore store;
  private JdbiUseStore uses;
  private Statistics statistics;

  Database open() throws SQLException {
    return Database.inMemory("statistics-" + System.nanoTime());
  }

  @BeforeEach
  void openStore() throws SQLException {
    database = open();
    store = new JdbiFleetStore(database.jdbi());
    uses = new JdbiUseStore(database.jdbi());
    statistics = new Statistics(database.jdbi());
    for (String robot : List.of("r1", "r2")) {
      store.saveRobot(new RobotRecord(robot, "lab", "127.0.0.1", 7275, 5, null, true, null));
    }
  }

  @AfterEach
  void closeStore() {
    database.close();
  }

  @Test
  void tasksAreCountedWhereTheyWereOrderedAndWhereTheyEnded() {
    done(NOON, 10, 60, 90);
    done(NOON.plus(Duration.ofHours(11)), 10, 60, 7200); // ends after midnight
    TransportTask cancelled = ordered(NOON);
    change(cancelled, TaskState.CANCELLED, NOON.plusSeconds(5));
    ordered(NOON); // and is open still

    List<Figures> days = days(DAY, DAY.plusDays(2));

    assertEquals(List.of(4L, 0L, 0L), each(days, Figures::ordered));
    assertEquals(List.of(1L, 1L, 0L), each(days, Figures::done));
    assertEquals(List.of(1L, 0L, 0L), each(days, Figures::cancelled));
    assertEquals(List.of(0L, 0L, 0L), each(days, Figures::failed));
  }

  @Test
  void durationsHaveMeanMedianAndNinetiethPercentile() {
    for (int seconds = 10; seconds <= 100; seconds += 10) {
      done(NOON, seconds, 200 + seconds, 1000 + seconds);
    }

    Figures day = statistics.of(Period.of(DAY, DAY, UTC)).total();

    // of 10, 20 ... 100: mean 550 / 10, the 5th, the 9th
    assertEquals(new Spread(10, 55, 50, 90), day.waiting());
    assertEquals(new Spread(10, 255, 250, 290), day.delivery());
    assertEquals(new Spread(10, 1055, 1050, 1090), day.completion());
  }

  @Test
  void waitingEndsWithTheFirstAssignment() {
    TransportTask task = ordered(NOON);
    change(task, TaskState.ASSIGNED, NOON.plusSeconds(30));
    change(task, TaskState.QUEUED, NOON.plusSeconds(40)); // its robot failed
    change(task, TaskState.ASSIGNED, NOON.plusSeconds(90));
    TransportTask never = ordered(NOON);
    change(never, TaskState.CANCELLED, NOON.plusSeconds(5));

    Figures day = statistics.of(Period.of(DAY, DAY, UTC)).total();

    assertEquals(new Spread(1, 30, 30, 30), day.waiting());
    assertNull(day.delivery());
  }

  @Test
  void aDayOfTheReadersZoneMayHave25Hours() {
    ordered(Instant.parse("2026-10-24T21:59:59Z")); // 23:59 of the 24th
    ordered(Instant.parse("2026-10-24T22:00:00Z")); // 0:00 of the 25th
    ordered(Instant.parse("2026-10-25T22:59:59Z")); // 23:59 of the 25th, after 25 hours
    ordered(Instant.parse("2026-10-25T23:00:00Z")); // 0:00 of the 26th

    Period three = Period.of(LocalDate.of(2026, 10, 24), LocalDate.of(2026, 10, 26), PARIS);
    Period one = Period.of(LocalDate.of(2026, 10, 25), LocalDate.of(2026, 10, 25), PARIS);

    assertEquals(List.of(1L, 2L, 1L), each(statistics.of(three).series(), Figures::ordered));
    assertEquals(25, statistics.of(one).series().size());
    assertEquals(2, statistics.of(one).total().ordered());
  }

  @Test
  void aRobotsUseIsSummedUp() {
    uses.save(
        List.of(
            use("r1", NOON, Map.of(RobotUse.WORKING, 600, RobotUse.IDLE, 1200), 120.5, 0.02),
            use("r1", NOON.plus(Duration.ofDays(1)), Map.of(RobotUse.WORKING, 1800), 300, 0.05),
            use("r2", NOON, Map.of(RobotUse.CHARGING, 1800), 0, 0)));

    PeriodFigures figures = statistics.of(Period.of(DAY, DAY.plusDays(2), UTC));

    RobotFigures r1 = figures.robots().getFirst();
    assertEquals(2400, r1.seconds(RobotUse.WORKING)); // 600 + 1800
    assertEquals(3600, r1.recorded()); // 600 + 1200 + 1800
    assertEquals(2.0 / 3, r1.share(RobotUse.WORKING), 1e-9);
    assertEquals(420.5, r1.metres(), 1e-9);
    assertEquals(0.07, r1.battery(), 1e-9);
    assertEquals(1, figures.robots().getLast().share(RobotUse.CHARGING));
    assertEquals(120.5, figures.series().getFirst().metres(), 1e-9);
    assertEquals(420.5, figures.total().metres(), 1e-9);
    assertEquals(0.07, figures.total().battery(), 1e-9);
  }

  @Test
  void aRecordThatIsSavedAgainIsReplaced() {
    uses.save(List.of(use("r1", NOON, Map.of(RobotUse.IDLE, 30), 0, 0)));
    uses.save(
        List.of(
            use("r1", NOON, Map.of(RobotUse.IDLE, 30, RobotUse.WORKING, 30), 4, 0.01),
            use("nobody", NOON, Map.of(RobotUse.IDLE, 30), 0, 0)));

    List<RobotFigures> robots = statistics.of(Period.of(DAY, DAY, UTC)).robots();

    assertEquals(1, robots.size());
    assertEquals(60, robots.getFirst().recorded());
    assertEquals(4, robots.getFirst().metres(), 1e-9);
  }

  @Test
  void whatWentWrongIsCountedOnce() {
    store.addEvents(
        List.of(
            event(NOON, "task.robot-failed", 7L, "r1", "r1 reports an error"),
            event(NOON, "task.robot-failed", 7L, "r1", "Waits for a robot"), // of the same step
            event(NOON, "task.robot-failed", 8L, "r2", "r2 reports an error"),
            event(NOON, "traffic.standstill", null, "r1", "r1 and r2"),
            event(NOON, "traffic.standstill", null, "r2", "r1 and r2"), // the same standstill
            event(NOON.plus(Duration.ofDays(1)), "task.late", 7L, null, "late"),
            event(NOON.plus(Duration.ofDays(9)), "task.late", 9L, null, "later than asked"),
            event(NOON, "task.started", 7L, "r1", "no failure")));

    PeriodFigures figures = statistics.of(Period.of(DAY, DAY.plusDays(2), UTC));

    Map<Failure, Long> total = figures.total().failures();
    assertEquals(2, total.get(Failure.ROBOT_FAILED));
    assertEquals(1, total.get(Failure.STANDSTILL));
    assertEquals(1, total.get(Failure.LATE));
    assertEquals(0, total.get(Failure.ROBOT_LOST));
    assertEquals(
        List.of(0L, 1L, 0L), each(figures.series(), day -> day.failures().get(Failure.LATE)));
  }

  /** Counted apart by a statement without buckets, over tasks and zones that chance chose. */
  @Test
  void bucketsSumUpToTheWhole() {
    Random random = new Random(26);
    for (int i = 0; i < 150; i++) {
      Instant at = NOON.minusSeconds(random.nextInt(60 * 86_400));
      if (random.nextInt(4) == 0) {
        change(ordered(at), TaskState.CANCELLED, at.plusSeconds(random.nextInt(9000)));
      } else {
        done(at, random.nextInt(600), 600 + random.nextInt(600), 1200 + random.nextInt(100_000));
      }
    }
    for (int days : new int[] {1, 2, 30, 61, 100, 400}) {
      Period period = Period.of(DAY.minusDays(days - 1), DAY, PARIS);
      PeriodFigures figures = statistics.of(period);
      assertSum(period, "created_at", "true", figures, Figures::ordered);
      assertSum(period, "changed_at", "state = 'DONE'", figures, Figures::done);
      assertSum(period, "changed_at", "state = 'CANCELLED'", figures, Figures::cancelled);
      assertSum(period, "assigned_at", "true", figures, f -> count(f.waiting()));
      assertSum(period, "delivered_at", "true", figures, f -> count(f.delivery()));
      assertSum(period, "changed_at", "state = 'DONE'", figures, f -> count(f.completion()));
    }
  }

  private void assertSum(
      Period period,
      String column,
      String condition,
      PeriodFigures figures,
      ToLongFunction<Figures> part) {
    long counted =
        database
            .jdbi()
            .withHandle(
                h ->
                    h.createQuery(
                            "select count(*) from tasks where %s >= :a and %s < :b and %s"
                                .formatted(column, column, condition))
                        .bind("a", Sql.utc(period.begin()))
                        .bind("b", Sql.utc(period.end()))
                        .mapTo(Long.class)
                        .one());
    assertEquals(counted, figures.series().stream().mapToLong(part).sum(), column);
    assertEquals(counted, part.applyAsLong(figures.total()), column);
  }

  private static long count(@Nullable Spread spread) {
    return spread == null ? 0 : spread.count();
  }

  private List<Figures> days(LocalDate from, LocalDate to) {
    return statistics.of(Period.of(from, to, UTC)).series();
  }

  private static List<Long> each(List<Figures> series, ToLongFunction<Figures> part) {
    return series.stream().map(part::applyAsLong).toList();
  }

  /** Seconds from the order. */
  private void done(Instant at, long assigned, long delivered, long ended) {
    TransportTask task = ordered(at);
    change(task, TaskState.ASSIGNED, at.plusSeconds(assigned));
    change(task, TaskState.CARRYING, at.plusSeconds(assigned + 1));
    change(task, TaskState.RETURNING, at.plusSeconds(delivered));
    change(task, TaskState.DONE, at.plusSeconds(ended));
  }

  private void change(TransportTask task, TaskState state, Instant at) {
    store.saveMission(new Mission(task, state, List.of(), false, null, null, null), at, List.of());
  }

  private TransportTask ordered(Instant at) {
    TaskPlace here = new TaskPlace(new Vec2(1, 1), null);
    TaskPlace there = new TaskPlace(new Vec2(2, 2), null);
    TransportTask task =
        new TransportTask(0, "box", 1, here, there, "lab", 0, null, null, "Ann", at);
    return store.addTasks(List.of(new Submission(task, UUID.randomUUID()))).getFirst();
  }

  private static UseRecord use(
      String robot, Instant at, Map<RobotUse, Integer> seconds, double metres, double battery) {
    Map<RobotUse, Duration> time = new EnumMap<>(RobotUse.class);
    seconds.forEach((use, s) -> time.put(use, Duration.ofSeconds(s)));
    return new UseRecord(robot, at, time, metres, battery);
  }

  private static EventRecord event(
      Instant at, String kind, @Nullable Long task, @Nullable String robot, String text) {
    return new EventRecord(at, kind, task, robot, EventRecord.SYSTEM, Sentence.verbatim(text));
  }
}
