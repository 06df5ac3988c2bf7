package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.MissionChange;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.geometry.Vec2;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.mission.Trouble;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What every database must do for tasks; here H2, in {@code MySqlFleetStoreTest} MySQL. */
class FleetStoreTest extends FleetDatabaseTest {
  @Test
  void aTaskIsFoundByItsIdempotencyKey() {
    UUID key = UUID.randomUUID();
    assertEquals(Optional.empty(), store.taskByKey(key));

    long id =
        store.addTasks(List.of(new FleetStore.Submission(task("keyed"), key))).getFirst().id();

    assertEquals(id, store.taskByKey(key).orElseThrow().id());
    assertEquals(Optional.empty(), store.taskByKey(UUID.randomUUID()));
  }

  @Test
  void ofTasksThatComeTogetherAllAreStoredOrNone() {
    UUID key = UUID.randomUUID();
    List<Submission> submissions =
        List.of(
            new Submission(task("first"), UUID.randomUUID()),
            new Submission(task("second"), key),
            new Submission(task("third"), key)); // which the database refuses

    assertThrows(StoreException.class, () -> store.addTasks(submissions));

    assertEquals(0, store.count());
    assertEquals(Optional.empty(), store.taskByKey(key));
  }

  @Test
  void aTaskComesBackWithEveryField() {
    TransportTask asked =
        new TransportTask(
                0,
                "Kiste für Zoë \uD83D\uDCE6 <b>",
                2.25,
                new TaskPlace(new Vec2(1.5, -2.5), "Store A"),
                new TaskPlace(new Vec2(0.1, 0.2), null),
                "lab",
                3,
                AT.plusSeconds(60),
                new LoadSize(0.6, 0.4),
                "Ann",
                AT)
            .withOnlyRobots(List.of("r2", "r.1_b"))
            .withStops(
                List.of(
                    new Stop(new TaskPlace(new Vec2(1.5, -2.5), "Store A"), true, null),
                    new Stop(
                        new TaskPlace(new Vec2(0.1, 0.2), null), false, Duration.ofSeconds(90))));
    TransportTask stored = added(asked);
    assertTrue(stored.id() > 0);
    assertEquals(List.of(new OpenTask(Mission.queued(stored), AT)), store.openTasks());
    assertEquals(stored, store.task(stored.id()).orElseThrow().task());
    assertEquals("Created by Ann", store.history(stored.id()).getFirst().text());
  }

  @Test
  void aMissionComesBackInThePhaseItWasStoredIn() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    TransportTask task = added(task("two"));
    Mission.Step step =
        Mission.queued(task).assign(List.of("r2", "r1"), Sentence.verbatim("heavy"));
    store.saveMission(step.mission(), AT, List.of());
    Mission.Step next = step.mission().apply(new MissionEvent.PhaseEnded("r1", Phase.TO_OBJECT));
    EventRecord event =
        new EventRecord(AT, "task.at-object", task.id(), "r1", "toqa", Sentence.verbatim("here"))
            .onFloor("lab");
    store.saveMission(next.mission(), AT.plusMillis(5), List.of(event));

    OpenTask open = store.openTasks().getFirst();
    assertEquals(next.mission(), open.mission());
    assertEquals(
        List.of(
            new AssignedRobot("r2", Phase.TO_OBJECT, false, false),
            new AssignedRobot("r1", Phase.TO_OBJECT, true, false)),
        open.mission().assignedRobots());
    assertEquals(AT.plusMillis(5), open.changedAt());
    assertEquals(event, store.history(task.id()).getLast());
    assertEquals(List.of("r2", "r1"), store.task(task.id()).orElseThrow().robots());
  }

  @Test
  void aRobotThatLosesItsTaskIsAvailableAgain() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    Mission mission =
        Mission.queued(added(task("box")))
            .assign(List.of("r1"), Sentence.verbatim("near"))
            .mission();
    store.saveMission(mission, AT, List.of());
    assertEquals(List.of("r1 0 in 1", "r2 1 in 0"), availability());

    Mission exchanged =
        mission
            .apply(new MissionEvent.Exchanged("r1", "r2", Sentence.verbatim("nearer")))
            .mission();
    store.saveMission(exchanged, AT, List.of());

    assertEquals(List.of("r1 1 in 0", "r2 0 in 1"), availability());
  }

  @Test
  void ofChangesThatBelongTogetherAllAreStoredOrNone() {
    store.saveRobot(R1);
    Mission one =
        Mission.queued(added(task("one")))
            .assign(List.of("r1"), Sentence.verbatim("near"))
            .mission();
    Mission bad =
        Mission.queued(added(task("two")))
            .assign(List.of("nobody"), Sentence.verbatim("?"))
            .mission();

    assertThrows(
        StoreException.class,
        () ->
            store.saveMissions(
                List.of(
                    new MissionChange(one, AT, List.of()), new MissionChange(bad, AT, List.of()))));

    assertEquals(
        List.of(TaskState.QUEUED, TaskState.QUEUED),
        store.openTasks().stream().map(t -> t.mission().state()).toList());
    assertEquals(List.of("r1 1 in 0"), availability());
  }

  @Test
  void aMissionComesBackWithAllThatPeopleSaidAndRobotsFailed() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    TransportTask task = added(task("odd"));
    TaskPlace place = new TaskPlace(new Vec2(1.25, -3.5), null);
    Mission odd =
        new Mission(
            task,
            TaskState.CARRYING,
            List.of(new AssignedRobot("r1", Phase.TO_GOAL, false, false)),
            true,
            LoadChoice.BACK,
            place,
            new Trouble("r1", Phrase.REPORTS_CODE.with("BUMPER"), place, true));
    store.saveMission(odd, AT, List.of());
    assertEquals(odd, store.openTasks().getFirst().mission());

    Mission other =
        new Mission(
            task,
            TaskState.QUEUED,
            List.of(new AssignedRobot("r2", Phase.TO_OBJECT, false, true)),
            false,
            null,
            null,
            null);
    store.saveMission(other, AT, List.of());
    assertEquals(other, store.openTasks().getFirst().mission());
  }

  @Test
  void ofWhoIsDisabledOrDeletedNothingIsStoredAndOfOthersWithHimNothing() {
    JdbiAccountStore accounts =
        new JdbiAccountStore(database.jdbi(), () -> AT, new LastKnownUsers());
    long ann = accounts.add("Ann", "hash", Role.CLERK, "Max").orElseThrow().id();
    long bob = accounts.add("Bob", "hash", Role.CLERK, "Max").orElseThrow().id();
    assertEquals(ann, added(task("hers").withOwner("Ann", ann)).owner());

    accounts.update(ann, Role.CLERK, true, "Max");
    assertUnknownUser(task("late").withOwner("Ann", ann), task("his").withOwner("Bob", bob));
    assertEquals(AccountStore.ChangeResult.OPEN_TASKS, accounts.delete(ann, "Max"));
    Mission hers = store.openTasks().getFirst().mission();
    store.saveMission(
        hers.apply(new MissionEvent.HandOver("Max", "Bob", bob)).mission(), AT, List.of());
    assertEquals(AccountStore.ChangeResult.DONE, accounts.delete(ann, "Max"));

    assertEquals("Ann", accounts.add("Ann", "hash", Role.CLERK, "Max").orElseThrow().name());
    assertUnknownUser(task("later").withOwner("Ann", ann));
    assertEquals(bob, added(task("his").withOwner("Bob", bob)).owner());
    assertEquals(2, store.openTasks().size());
  }

  private void assertUnknownUser(TransportTask... tasks) {
    List<Submission> together =
        Stream.of(tasks).map(task -> new Submission(task, UUID.randomUUID())).toList();
    assertEquals(
        StoreException.Kind.UNKNOWN_USER,
        assertThrows(StoreException.class, () -> store.addTasks(together)).kind());
  }

  @Test
  void aChangeThatFailsHasNotHappened() {
    TransportTask task = added(task("one"));
    Mission unknownRobot =
        Mission.queued(task).assign(List.of("nobody"), Sentence.verbatim("?")).mission();
    assertThrows(StoreException.class, () -> store.saveMission(unknownRobot, AT, List.of()));
    assertEquals(TaskState.QUEUED, store.openTasks().getFirst().mission().state());
  }

  /** Of each robot: name, whether it can be given a task, and its phase. */
  private List<String> availability() {
    return database
        .jdbi()
        .withHandle(
            h ->
                h.createQuery(
                        "select concat(name, ' ', availability, ' in ', phase) from robots order by name")
                    .mapTo(String.class)
                    .list());
  }
}
