package org.toqa.fleet.schedule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.allocation.Policy;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.FleetStage;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.TamperedStore;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.grid.FloorReader;
import org.toqa.mission.MissionEvent;
import org.toqa.persistence.StoreException;
import org.toqa.store.JdbiAccountStore;
import org.toqa.store.JdbiEventArchive;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.LastKnownUsers;

/** Schedules by a clock that is set, over a real fleet and a real store. */
@Timeout(120)
class SchedulerTest {
  private static final Instant START = Instant.parse("2026-11-21T10:00:00Z");
  private static final Duration HALF_HOUR = Duration.ofMinutes(30);

  private static final TaskOrder BOX =
      new TaskOrder(
          "box",
          1,
          new Where.Station("Goods-in 1"),
          new Where.Station("Mill"),
          null,
          0,
          null,
          null);

  private Instant now = START;
  private FleetStage stage;
  private JdbiScheduleStore schedules;
  private Scheduler scheduler;
  private AccountStore accounts;
  private Account clara;

  @BeforeEach
  void start() throws Exception {
    start(UnaryOperator.identity());
  }

  private void start(UnaryOperator<FleetStore> tamper) throws Exception {
    stage = stage(tamper);
    schedules = new JdbiScheduleStore(stage.database.jdbi());
    accounts = new JdbiAccountStore(stage.database.jdbi(), () -> now, new LastKnownUsers());
    clara = accounts.add("Clara", "hash", Role.CLERK, "Max").orElseThrow();
    scheduler = scheduler(schedules);
  }

  private static FleetStage stage(UnaryOperator<FleetStore> tamper) throws Exception {
    return new FleetStage(
        FloorReader.read(Path.of("maps", "lab.yaml")),
        ChargingRules.USUAL,
        Policy.OPTIMAL.method(),
        tamper);
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void eachDueTimeMakesOneOrdinaryTask() throws Exception {
    long id = addEvery(START.plusSeconds(60), null);

    look(START.plusSeconds(59));
    assertEquals(0, stage.store.count());
    look(START.plusSeconds(60));
    look(START.plusSeconds(61));

    assertEquals(1, stage.store.count());
    TaskView task = stage.store.tasks(0, 1).getFirst();
    assertEquals("box", task.task().name());
    assertEquals("Clara", task.task().user());
    assertEquals(task.id(), schedule(id).lastTask());
    assertEquals(START.plusSeconds(60).plus(HALF_HOUR), schedule(id).due());
    assertEquals("Created by schedule 1 of Clara", stage.store.history(task.id()).getLast().text());
    cancel(task.id());
    look(START.plusSeconds(60).plus(HALF_HOUR));
    assertEquals(2, stage.store.count());
  }

  @Test
  void whileTheLastTaskIsOpenTheNextIsSkippedAndThatIsTold() throws Exception {
    long id = addEvery(START.plusSeconds(1), null);
    look(START.plusSeconds(1));
    long first = stage.store.tasks(0, 1).getFirst().id();

    look(START.plus(HALF_HOUR).plusSeconds(1));

    assertEquals(1, stage.store.count());
    assertEquals(
        "Schedule 1 of Clara was skipped because its last task 1 has not ended",
        stage.store.history(first).getLast().text());
    assertEquals(START.plusSeconds(1).plus(HALF_HOUR.multipliedBy(2)), schedule(id).due());
  }

  @Test
  void ofWhatWasDueWhileNoServerRanOneIsMadeUpFor() throws Exception {
    long id = addEvery(START.plusSeconds(1), null);

    look(START.plus(Duration.ofDays(3)));
    cancel(1);
    look(START.plus(Duration.ofDays(3)));

    assertEquals(1, stage.store.count());
    assertEquals(START.plus(Duration.ofDays(3)).plusSeconds(1), schedule(id).due());
  }

  @Test
  void whatWasMissedIsTold() throws Exception {
    addEvery(START.plusSeconds(1), null);

    look(START.plus(Duration.ofDays(3)));

    // 144 half hours in three days, of which one is made up for
    assertEquals(
        "Schedule 1 of Clara missed 143 other times, while no server ran or its clock jumped",
        stage.store.history(1).getLast().text());
  }

  @Test
  void aClockThatJumpsForwardAndBackLeavesNoScheduleWaiting() throws Exception {
    long id = addEvery(START.plusSeconds(1), null);
    look(START.plus(Duration.ofDays(1_000)));
    cancel(1);

    look(START.plusSeconds(2));
    assertEquals(START.plusSeconds(1).plus(HALF_HOUR), schedule(id).due());
    look(START.plusSeconds(1).plus(HALF_HOUR));

    assertEquals(2, stage.store.count());
  }

  @Test
  void aClockThatJumpsBeyondTheEndOfAScheduleAndBackDoesNotEndIt() throws Exception {
    Instant first = START.plusSeconds(1);
    long id = addEvery(first, first.plus(HALF_HOUR.multipliedBy(2)));
    long once = add(BOX, new Recurrence.Once(first), null);
    look(START.plus(Duration.ofDays(1_000)));
    assertNull(schedule(id).due());
    assertEquals(2, stage.store.count());
    cancel(1);
    cancel(2);

    look(START);
    assertEquals(first, schedule(id).due());
    assertNull(schedule(once).due(), "its task was put in");
    look(first); // of which the task is there
    look(first.plus(HALF_HOUR));
    assertEquals(3, stage.store.count());
    cancel(3);
    look(first.plus(HALF_HOUR.multipliedBy(2)));
    cancel(4);
    assertNull(schedule(id).due());

    look(first.plus(HALF_HOUR.multipliedBy(3)));
    look(first.plus(HALF_HOUR.multipliedBy(2)).plusSeconds(1)); // after its end
    assertNull(schedule(id).due());
    assertEquals(4, stage.store.count());
  }

  @Test
  void aServerThatEndsBetweenTheTaskAndItsNotePutsInNoSecondOne() throws Exception {
    long id = addEvery(START.plusSeconds(1), null);
    Scheduler dying = scheduler(withoutAdvance());
    now = START.plusSeconds(1);

    assertThrows(IllegalStateException.class, dying::runDueSchedules);
    assertEquals(1, stage.store.count());
    assertNull(schedule(id).lastTask());
    stage.restart();
    scheduler = scheduler(schedules);
    cancel(1); // also when the task is over
    look(START.plusSeconds(30));

    assertEquals(1, stage.store.count());
    assertEquals(1L, schedule(id).lastTask());
    assertEquals(START.plusSeconds(1).plus(HALF_HOUR), schedule(id).due());
  }

  @Test
  void whileItsUserIsDisabledAScheduleRestsAndNothingIsMadeUpFor() throws Exception {
    long id = addEvery(START.plusSeconds(1), null);
    accounts.update(clara.id(), Role.CLERK, true, "Max");
    look(START.plusSeconds(1));

    assertEquals(0, stage.store.count());
    assertTrue(schedule(id).resting());
    assertEquals(START.plusSeconds(1).plus(HALF_HOUR), schedule(id).due());
    accounts.update(clara.id(), Role.CLERK, false, "Max");
    look(START.plusSeconds(60));
    assertEquals(0, stage.store.count());
    look(START.plusSeconds(1).plus(HALF_HOUR));
    assertEquals(1, stage.store.count());
    assertEquals(clara.id(), stage.store.tasks(0, 1).getFirst().task().owner());
  }

  @Test
  void whoGetsTheNameOfADeletedUserGetsNoTaskOfHisSchedules() throws Exception {
    long id = addEvery(START.plusSeconds(1), null);
    stage.database.jdbi().useHandle(h -> h.execute("delete from users"));
    accounts.add("Clara", "hash", Role.CLERK, "Max");
    look(START.plusSeconds(1));

    assertEquals(0, stage.store.count());
    assertNull(schedule(id).owner());
  }

  @Test
  void aScheduleEndsAtItsEnd() throws Exception {
    long id = addEvery(START.plusSeconds(1), START.plusSeconds(1).plus(HALF_HOUR));
    look(START.plusSeconds(1));
    cancel(1);

    look(START.plusSeconds(1).plus(HALF_HOUR));

    assertEquals(2, stage.store.count());
    assertNull(schedule(id).due());
    cancel(2);
    look(START.plus(Duration.ofDays(1)));
    assertEquals(2, stage.store.count());
  }

  @Test
  void whatIsPausedIsNotDue() {
    long id = addEvery(START.plusSeconds(1), null);
    schedules.savePause(id, true, START.plusSeconds(1), List.of());
    look(START.plusSeconds(1));
    assertEquals(0, stage.store.count());

    schedules.savePause(id, false, START.plusSeconds(2), List.of());
    look(START.plusSeconds(2));

    assertEquals(1, stage.store.count());
  }

  @Test
  void aRunOfWhichNobodyKnowsWhetherItWasStoredIsNotLost() throws Exception {
    stage.close();
    AtomicBoolean dies = new AtomicBoolean(true);
    start(
        store ->
            TamperedStore.of(
                store,
                (method, arguments, call) -> {
                  Object result = call.go();
                  if (method.equals("addTasks") && dies.getAndSet(false)) {
                    stage.stopStoreFor(agent -> agent.startsWith("tasks-"));
                    throw new StoreException("It was stored, but nobody knows.", null);
                  }
                  return result;
                }));
    long id = addEvery(START.plusSeconds(1), null);

    look(START.plusSeconds(1));
    look(START.plusSeconds(2)); // while it is there, and is to be withdrawn
    assertEquals(START.plusSeconds(1), schedule(id).due());
    stage.startStore();
    stage.awaitQuiescence();
    look(START.plusSeconds(3));

    stage.awaitQuiescence();
    assertEquals(1, stage.store.count());
    assertEquals(stage.store.tasks(0, 1).getFirst().id(), schedule(id).lastTask());
  }

  @Test
  void whatTheFleetRefusesIsToldAndTriedAtTheNextTime() {
    TaskOrder gone =
        new TaskOrder(
            "box", 1, new Where.Station("Gone"), new Where.Station("Mill"), null, 0, null, null);
    long id = add(gone, new Recurrence.Every(START.plusSeconds(1), HALF_HOUR), null);

    look(START.plusSeconds(1));

    assertEquals(0, stage.store.count());
    assertEquals(START.plusSeconds(1).plus(HALF_HOUR), schedule(id).due());
    Filter refused = new Filter(null, null, null, "schedule.refused", null, null, false);
    String told =
        new JdbiEventArchive(stage.database.jdbi())
            .events(refused, Long.MAX_VALUE, 10)
            .getFirst()
            .event()
            .text();
    assertTrue(
        told.startsWith("Schedule 1 of Clara could not create a task: There is no station Gone"),
        told);
  }

  private void look(Instant at) {
    now = at;
    scheduler.runDueSchedules();
  }

  private Scheduler scheduler(ScheduleStore store) {
    return new Scheduler(store, stage.store, stage.fleet, () -> now);
  }

  /** A store behind which the server ends when something was put in. */
  private ScheduleStore withoutAdvance() {
    return (ScheduleStore)
        Proxy.newProxyInstance(
            ScheduleStore.class.getClassLoader(),
            new Class<?>[] {ScheduleStore.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("advance")) {
                throw new IllegalStateException("killed");
              }
              try {
                return method.invoke(schedules, arguments);
              } catch (InvocationTargetException e) {
                throw e.getCause();
              }
            });
  }

  private Schedule schedule(long id) {
    return schedules.schedule(id).orElseThrow();
  }

  private void cancel(long task) throws Exception {
    stage
        .fleet
        .commandTask(task, new MissionEvent.Cancel("Clara", null))
        .toCompletableFuture()
        .get(20, TimeUnit.SECONDS);
  }

  private long addEvery(Instant first, @Nullable Instant until) {
    return add(BOX, new Recurrence.Every(first, HALF_HOUR), until);
  }

  private long add(TaskOrder order, Recurrence recurrence, @Nullable Instant until) {
    return schedules
        .add(
            Schedule.of(order, recurrence, until, Orderer.named("Clara"), START), UUID.randomUUID())
        .orElseThrow();
  }
}
