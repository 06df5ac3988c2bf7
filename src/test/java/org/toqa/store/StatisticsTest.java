package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

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
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.ExpectedDelivery;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.history.DurationStatistics;
import org.toqa.fleet.history.FailureKind;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.RobotUtilisation;
import org.toqa.fleet.history.UtilisationRecord;
import org.toqa.fleet.history.WorkStatistics;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.LabTask;
import org.toqa.wording.Sentence;

/** What a period is in numbers; here on H2, in {@code MySqlStatisticsTest} on MySQL. */
class StatisticsTest extends DatabaseTest {
  private static final ZoneId UTC = ZoneId.of("UTC");
  private static final ZoneId PARIS = ZoneId.of("Europe/Paris");
  private static final LocalDate DAY = LocalDate.of(2026, 11, 20);
  private static final Instant NOON = Instant.parse("2026-11-20T12:00:00Z");

  private JdbiFleetStore store;
  private JdbiUtilisationStore uses;
  private JdbiStatisticsArchive statistics;

  @BeforeEach
  void openStore() {
    store = new JdbiFleetStore(database.jdbi());
    uses = new JdbiUtilisationStore(database.jdbi());
    statistics = new JdbiStatisticsArchive(database.jdbi());
    for (String robot : List.of("r1", "r2")) {
      store.saveRobot(RobotRecord.direct(robot, "lab", "127.0.0.1", 7275, 5, null, true, null));
    }
  }

  @Test
  void tasksAreCountedWhereTheyWereOrderedAndWhereTheyEnded() {
    done(NOON, 10, 60, 90);
    done(NOON.plus(Duration.ofHours(11)), 10, 60, 7200); // ends after midnight
    TransportTask cancelled = ordered(NOON);
    change(cancelled, TaskState.CANCELLED, NOON.plusSeconds(5));
    ordered(NOON); // and is open still

    List<WorkStatistics> days = days(DAY, DAY.plusDays(2));

    assertEquals(List.of(4L, 0L, 0L), each(days, WorkStatistics::ordered));
    assertEquals(List.of(1L, 1L, 0L), each(days, WorkStatistics::done));
    assertEquals(List.of(1L, 0L, 0L), each(days, WorkStatistics::cancelled));
    assertEquals(List.of(0L, 0L, 0L), each(days, WorkStatistics::failed));
  }

  @Test
  void durationsHaveMeanMedianAndNinetiethPercentile() {
    for (int seconds = 10; seconds <= 100; seconds += 10) {
      done(NOON, seconds, 200 + seconds, 1000 + seconds);
    }

    WorkStatistics day = statistics.statistics(Period.of(DAY, DAY, UTC)).total();

    // of 10, 20 ... 100: mean 550 / 10, the 5th, the 9th
    assertEquals(new DurationStatistics(10, 55, 50, 90), day.waiting());
    assertEquals(new DurationStatistics(10, 255, 250, 290), day.delivery());
    assertEquals(new DurationStatistics(10, 1055, 1050, 1090), day.completion());
  }

  @Test
  void whatWasExpectedIsComparedWithWhatCame() {
    TransportTask task = ordered(NOON);
    store.saveExpectations(
        List.of(
            new ExpectedDelivery(task.id(), false, NOON.plusSeconds(50)),
            new ExpectedDelivery(task.id(), true, NOON.plusSeconds(85))));
    store.saveExpectations( // which comes too late
        List.of(new ExpectedDelivery(task.id(), true, NOON.plusSeconds(100))));
    change(task, TaskState.ASSIGNED, NOON.plusSeconds(20));
    change(task, TaskState.RETURNING, NOON.plusSeconds(80));
    done(NOON, 10, 60, 90); // of which nothing was said

    WorkStatistics day = statistics.statistics(Period.of(DAY, DAY, UTC)).total();

    assertEquals(new DurationStatistics(1, 30, 30, 30), day.orderError());
    assertEquals(new DurationStatistics(1, 5, 5, 5), day.startError());
  }

  @Test
  void waitingEndsWithTheFirstAssignment() {
    TransportTask task = ordered(NOON);
    change(task, TaskState.ASSIGNED, NOON.plusSeconds(30));
    change(task, TaskState.QUEUED, NOON.plusSeconds(40)); // its robot failed
    change(task, TaskState.ASSIGNED, NOON.plusSeconds(90));
    TransportTask never = ordered(NOON);
    change(never, TaskState.CANCELLED, NOON.plusSeconds(5));

    WorkStatistics day = statistics.statistics(Period.of(DAY, DAY, UTC)).total();

    assertEquals(new DurationStatistics(1, 30, 30, 30), day.waiting());
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

    assertEquals(
        List.of(1L, 2L, 1L), each(statistics.statistics(three).buckets(), WorkStatistics::ordered));
    assertEquals(25, statistics.statistics(one).buckets().size());
    assertEquals(2, statistics.statistics(one).total().ordered());
  }

  @Test
  void aRobotsUseIsSummedUp() {
    uses.save(
        List.of(
            use(
                "r1",
                NOON,
                Map.of(RobotActivity.WORKING, 600, RobotActivity.IDLE, 1200),
                120.5,
                0.02),
            use(
                "r1",
                NOON.plus(Duration.ofDays(1)),
                Map.of(RobotActivity.WORKING, 1800),
                300,
                0.05),
            use("r2", NOON, Map.of(RobotActivity.CHARGING, 1800), 0, 0)));

    PeriodStatistics figures = statistics.statistics(Period.of(DAY, DAY.plusDays(2), UTC));

    RobotUtilisation r1 = figures.robots().getFirst();
    assertEquals(2400, r1.seconds(RobotActivity.WORKING)); // 600 + 1800
    assertEquals(3600, r1.recordedSeconds()); // 600 + 1200 + 1800
    assertEquals(2.0 / 3, r1.utilisation(RobotActivity.WORKING), 1e-9);
    assertEquals(420.5, r1.metres(), 1e-9);
    assertEquals(0.07, r1.battery(), 1e-9);
    assertEquals(1, figures.robots().getLast().utilisation(RobotActivity.CHARGING));
    assertEquals(120.5, figures.buckets().getFirst().metres(), 1e-9);
    assertEquals(420.5, figures.total().metres(), 1e-9);
    assertEquals(0.07, figures.total().battery(), 1e-9);
  }

  @Test
  void aRecordThatIsSavedAgainIsReplaced() {
    uses.save(List.of(use("r1", NOON, Map.of(RobotActivity.IDLE, 30), 0, 0)));
    uses.save(
        List.of(
            use("r1", NOON, Map.of(RobotActivity.IDLE, 30, RobotActivity.WORKING, 30), 4, 0.01),
            use("nobody", NOON, Map.of(RobotActivity.IDLE, 30), 0, 0)));

    List<RobotUtilisation> robots = statistics.statistics(Period.of(DAY, DAY, UTC)).robots();

    assertEquals(1, robots.size());
    assertEquals(60, robots.getFirst().recordedSeconds());
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

    PeriodStatistics figures = statistics.statistics(Period.of(DAY, DAY.plusDays(2), UTC));

    Map<FailureKind, Long> total = figures.total().failures();
    assertEquals(2, total.get(FailureKind.ROBOT_FAILED));
    assertEquals(1, total.get(FailureKind.STANDSTILL));
    assertEquals(1, total.get(FailureKind.LATE));
    assertEquals(0, total.get(FailureKind.ROBOT_LOST));
    assertEquals(
        List.of(0L, 1L, 0L), each(figures.buckets(), day -> day.failures().get(FailureKind.LATE)));
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
      PeriodStatistics figures = statistics.statistics(period);
      assertSum(period, "created_at", "true", figures, WorkStatistics::ordered);
      assertSum(period, "changed_at", "state = 'DONE'", figures, WorkStatistics::done);
      assertSum(period, "changed_at", "state = 'CANCELLED'", figures, WorkStatistics::cancelled);
      assertSum(period, "assigned_at", "true", figures, f -> count(f.waiting()));
      assertSum(period, "delivered_at", "true", figures, f -> count(f.delivery()));
      assertSum(period, "changed_at", "state = 'DONE'", figures, f -> count(f.completion()));
    }
  }

  private void assertSum(
      Period period,
      String column,
      String condition,
      PeriodStatistics figures,
      ToLongFunction<WorkStatistics> part) {
    long counted =
        database
            .jdbi()
            .withHandle(
                h ->
                    h.createQuery(
                            "select count(*) from tasks where %s >= :a and %s < :b and %s"
                                .formatted(column, column, condition))
                        .bind("a", period.begin())
                        .bind("b", period.end())
                        .mapTo(Long.class)
                        .one());
    assertEquals(counted, figures.buckets().stream().mapToLong(part).sum(), column);
    assertEquals(counted, part.applyAsLong(figures.total()), column);
  }

  private static long count(@Nullable DurationStatistics spread) {
    return spread == null ? 0 : spread.count();
  }

  private List<WorkStatistics> days(LocalDate from, LocalDate to) {
    return statistics.statistics(Period.of(from, to, UTC)).buckets();
  }

  private static List<Long> each(List<WorkStatistics> series, ToLongFunction<WorkStatistics> part) {
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
    TransportTask task = LabTask.of("box", "Ann", at);
    return store.addTasks(List.of(new Submission(task, UUID.randomUUID()))).getFirst();
  }

  private static UtilisationRecord use(
      String robot,
      Instant at,
      Map<RobotActivity, Integer> seconds,
      double metres,
      double battery) {
    Map<RobotActivity, Duration> time = new EnumMap<>(RobotActivity.class);
    seconds.forEach((use, s) -> time.put(use, Duration.ofSeconds(s)));
    return new UtilisationRecord(robot, at, time, metres, battery);
  }

  private static EventRecord event(
      Instant at, String kind, @Nullable Long task, @Nullable String robot, String text) {
    return new EventRecord(at, kind, task, robot, EventRecord.SYSTEM, Sentence.verbatim(text));
  }
}
