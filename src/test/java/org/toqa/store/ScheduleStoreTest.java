package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;

/** What every database must do for schedules; here H2, in {@code MySqlScheduleStoreTest} MySQL. */
class ScheduleStoreTest extends DatabaseTest {
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00.123Z");

  private JdbiScheduleStore store;

  @BeforeEach
  void openStore() {
    store = new JdbiScheduleStore(database.jdbi());
  }

  @Test
  void schedulesComeBackWithEveryField() {
    TaskOrder whole =
        new TaskOrder(
            "Kiste für Zoë",
            2.25,
            new Where.Point(new Vec2(1.5, -2.5)),
            new Where.Station("Mill"),
            "lab",
            -3,
            null,
            new LoadSize(0.6, 0.4));
    Schedule weekly =
        schedule(
            whole,
            new Recurrence.Weekly(
                Set.of(DayOfWeek.SUNDAY, DayOfWeek.MONDAY),
                LocalTime.of(8, 5),
                ZoneId.of("Europe/Berlin")),
            AT.plus(Duration.ofDays(30)));
    Schedule every =
        schedule(order(), new Recurrence.Every(AT.plusSeconds(5), Duration.ofMinutes(7)), null);
    Schedule once = schedule(order(), new Recurrence.Once(AT.plusSeconds(5)), null);

    List<Long> ids = List.of(add(weekly), add(every), add(once));

    assertEquals(
        List.of(stored(weekly, ids.get(0)), stored(every, ids.get(1)), stored(once, ids.get(2))),
        store.schedules());
    assertEquals(Optional.of(stored(every, ids.get(1))), store.schedule(ids.get(1)));
    assertEquals(Optional.empty(), store.schedule(99));
  }

  @Test
  void whatComesAgainWithItsKeyIsStoredOnce() {
    UUID key = UUID.randomUUID();
    Schedule once = schedule(order(), new Recurrence.Once(AT.plusSeconds(5)), null);

    assertEquals(store.add(once, key), store.add(once, key));

    assertEquals(1, store.schedules().size());
  }

  @Test
  void onlyWhatIsDueAndNotPausedIsDue() {
    long id = add(schedule(order(), new Recurrence.Once(AT.plusSeconds(5)), null));

    assertEquals(List.of(), store.due(AT.plusSeconds(4)));
    assertEquals(1, store.due(AT.plusSeconds(5)).size());
    store.savePause(id, true, AT.plusSeconds(5), List.of());
    assertEquals(List.of(), store.due(AT.plusSeconds(5)));
    store.savePause(id, false, AT.plusSeconds(5), List.of());
    Schedule before = store.due(AT.plusSeconds(5)).getFirst();
    store.advance(before, null, 7L, List.of());
    assertEquals(List.of(), store.due(AT.plusSeconds(500)));
    assertEquals(7L, store.schedule(id).orElseThrow().lastTask());
  }

  @Test
  void whatWasChangedMeanwhileIsNotAdvanced() {
    long id = add(schedule(order(), new Recurrence.Once(AT.plusSeconds(5)), null));
    Schedule before = store.schedule(id).orElseThrow();
    store.savePause(id, false, AT.plusSeconds(9), List.of());

    store.advance(before, null, 7L, List.of());

    assertEquals(AT.plusSeconds(9), store.schedule(id).orElseThrow().due());
    store.delete(id, List.of());
    store.advance(before, null, 7L, List.of());
    assertEquals(List.of(), store.schedules());
  }

  private long add(Schedule schedule) {
    return store.add(schedule, UUID.randomUUID()).orElseThrow();
  }

  private static Schedule schedule(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until) {
    return Schedule.of(order, recurrence, until, Orderer.named("Ann"), AT);
  }

  private static Schedule stored(Schedule s, long id) {
    return new Schedule(
        id,
        s.order(),
        s.recurrence(),
        s.until(),
        s.paused(),
        s.user(),
        null,
        true, // no user has that name
        s.createdAt(),
        s.due(),
        s.lastTask());
  }

  private static TaskOrder order() {
    return new TaskOrder(
        "box", 1, new Where.Station("A"), new Where.Station("B"), null, 0, null, null);
  }
}
