package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.sql.SQLException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.MissionChange;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.fleet.TaskArchive.Sort.Column;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.mission.Trouble;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What every database must do for the fleet; here H2, in {@code MySqlFleetStoreTest} MySQL. */
class FleetStoreTest {
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00.123Z");
  private static final RobotRecord R1 =
      new RobotRecord("r1", "lab", "127.0.0.1", 7275, 5, "P1", true, null);
  private static final RobotRecord R2 =
      new RobotRecord("r2", "lab", "host", 1, 2.5, null, false, null);

  private Database database;
  private JdbiFleetStore store;

  Database open() throws SQLException {
    return Database.inMemory("fleet-store-" + System.nanoTime());
  }

  @BeforeEach
  void openStore() throws SQLException {
    database = open();
    store = new JdbiFleetStore(database.jdbi());
  }

  @AfterEach
  void closeStore() {
    database.close();
  }

  @Test
  void robotsComeBackAsTheyWereStored() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    RobotRecord moved = new RobotRecord("r1", "lab", "127.0.0.1", 7300, 5, "P1", true, null);
    store.saveRobot(moved);
    assertEquals(List.of(moved, R2), store.robots());
  }

  @Test
  void aRobotStaysOutOfServiceWhenItsAddressChanges() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    assertEquals(Set.of(), robots(StoredRobot::outOfService));

    store.saveService("r1", false, List.of());
    store.saveService("r2", false, List.of());
    store.saveService("r2", true, List.of());
    store.saveRobot(new RobotRecord("r1", "lab", "127.0.0.1", 7300, 5, "P1", true, null));

    assertEquals(Set.of("r1"), robots(StoredRobot::outOfService));
    assertThrows(StoreException.class, () -> store.saveService("nobody", false, List.of()));
  }

  @Test
  void aRobotThatWasRemovedIsGoneUntilItIsAddedAgain() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    store.saveService("r1", false, List.of());

    store.removeRobot("r1", List.of());

    assertEquals(List.of(R2), store.robots());
    store.removeRobot("r1", List.of()); // it may be repeated
    assertThrows(StoreException.class, () -> store.removeRobot("nobody", List.of()));
    store.saveRobot(R1);
    assertEquals(Set.of("r1", "r2"), names(store.robots()));
    assertEquals(Set.of(), robots(StoredRobot::outOfService));
  }

  private Set<String> robots(Predicate<StoredRobot> condition) {
    return store.storedRobots().stream()
        .filter(condition)
        .map(StoredRobot::name)
        .collect(Collectors.toSet());
  }

  private List<ChargeRecord> charges() {
    return store.storedRobots().stream().map(StoredRobot::charge).toList();
  }

  private static Set<String> names(List<RobotRecord> robots) {
    return robots.stream().map(RobotRecord::name).collect(Collectors.toSet());
  }

  @Test
  void whatARobotHasWorkedAndWhereItChargesComesBack() {
    store.saveRobot(R1);
    ChargeRecord rested = new ChargeRecord("r1", Duration.ZERO, null);
    assertEquals(List.of(rested), charges());

    ChargeRecord waits = new ChargeRecord("r1", Duration.ofMinutes(90), new Turn("C1", AT));
    store.saveCharge(waits, List.of());
    store.saveRobot(new RobotRecord("r1", "lab", "127.0.0.1", 7300, 5, "P1", true, null));

    assertEquals(List.of(waits), charges());
    store.saveCharge(rested, List.of());
    assertEquals(List.of(rested), charges());
  }

  @Test
  void aTaskIsFoundByTheKeyOfItsWish() {
    UUID key = UUID.randomUUID();
    assertEquals(Optional.empty(), store.taskByKey(key));

    long id =
        store.addTasks(List.of(new FleetStore.Submission(task("wished"), key))).getFirst().id();

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
            AT);
    TransportTask stored = added(asked);
    assertTrue(stored.id() > 0);
    assertEquals(List.of(new OpenTask(Mission.queued(stored), AT)), store.openTasks());
    assertEquals(stored, store.task(stored.id()).orElseThrow().task());
    assertEquals("Asked for by Ann", store.history(stored.id()).getFirst().text());
  }

  @Test
  void aMissionComesBackInThePhaseItWasStoredIn() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    TransportTask task = added(task("two"));
    Mission.Step step =
        Mission.queued(task).assign(List.of("r2", "r1"), Sentence.verbatim("heavy"));
    store.saveMission(step.mission(), AT, List.of());
    Mission.Step next = step.mission().apply(new MissionEvent.PhaseEnded("r1", 1));
    EventRecord event =
        new EventRecord(AT, "task.at-object", task.id(), "r1", "toqa", Sentence.verbatim("here"));
    store.saveMission(next.mission(), AT.plusMillis(5), List.of(event));

    OpenTask open = store.openTasks().getFirst();
    assertEquals(next.mission(), open.mission());
    assertEquals(
        List.of(new AssignedRobot("r2", 1, false, false), new AssignedRobot("r1", 1, true, false)),
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
            List.of(new AssignedRobot("r1", 2, false, false)),
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
            List.of(new AssignedRobot("r2", 1, false, true)),
            false,
            null,
            null,
            null);
    store.saveMission(other, AT, List.of());
    assertEquals(other, store.openTasks().getFirst().mission());
  }

  @Test
  void whoIsOnHoldAndWhetherAllArePausedComesBack() {
    store.saveRobot(R1);
    store.saveHold("r1", true, List.of());
    Hold pause = new Hold("Ann", AT);
    store.savePause(pause, List.of());
    store.savePause(pause, List.of()); // twice is as once
    assertEquals(Set.of("r1"), robots(StoredRobot::held));
    assertEquals(Optional.of(pause), store.pause());

    store.saveHold("r1", false, List.of());
    store.savePause(null, List.of());
    assertEquals(Set.of(), robots(StoredRobot::held));
    assertEquals(Optional.empty(), store.pause());
  }

  @Test
  void floorsOnHoldComeBack() {
    Hold hold = new Hold("Ann", AT);
    store.saveFloorHold("hall", hold, List.of());
    store.saveFloorHold("hall", hold, List.of()); // twice is as once
    store.saveFloorHold("attic", new Hold("Max", AT), List.of());
    store.saveFloorHold("attic", null, List.of());

    assertEquals(Map.of("hall", hold), store.floorHolds());
  }

  @Test
  void endedTasksAreOnlyInTheArchive() {
    store.saveRobot(R1);
    TransportTask first = added(task("first"));
    TransportTask second = added(task("second"));
    store.saveMission(
        new Mission(
            first,
            TaskState.DONE,
            List.of(new AssignedRobot("r1", 3, true, true)),
            false,
            null,
            null,
            null),
        AT,
        List.of());
    assertEquals(
        List.of(second.id()), store.openTasks().stream().map(t -> t.mission().id()).toList());
    assertEquals(
        List.of(second.id(), first.id()), store.tasks(0, 10).stream().map(t -> t.id()).toList());
    assertEquals(List.of(first.id()), store.tasks(1, 10).stream().map(t -> t.id()).toList());
    assertEquals(2, store.count());
  }

  @Test
  void tasksAreFilteredAndSorted() {
    store.saveRobot(R1);
    long light = added(asked("Box 7%", 1, "Ann", AT)).id();
    long heavy = added(asked("crate_2", 9, "Max", AT.plusSeconds(60))).id();
    TransportTask third = added(asked("Other box", 5, "ann", AT.plusSeconds(120)));
    store.saveMission(
        Mission.queued(third).assign(List.of("r1"), Sentence.verbatim("near")).mission(),
        AT,
        List.of());

    assertEquals(List.of(third.id(), heavy, light), found(Filter.ANY, Sort.NEWEST_FIRST));
    assertEquals(List.of(third.id(), light), found(text("bOx")));
    assertEquals(List.of(light), found(text("7%")), "no wildcard");
    assertEquals(List.of(heavy), found(text("_")));
    assertEquals(List.of(heavy), found(text(String.valueOf(heavy))));
    assertEquals(
        List.of(third.id(), light), found(new Filter(Set.of(), null, "ANN", null, null, null)));
    assertEquals(List.of(third.id()), found(new Filter(Set.of(), "r1", null, null, null, null)));
    assertEquals(
        List.of(heavy, light),
        found(new Filter(Set.of(TaskState.QUEUED, TaskState.DONE), null, null, null, null, null)));
    assertEquals(
        List.of(heavy),
        found(new Filter(Set.of(), null, null, null, AT.plusSeconds(60), AT.plusSeconds(120))));
    assertEquals(List.of(), found(new Filter(Set.of(), "r2", "ann", "box", AT, null)));
    assertEquals(
        List.of(light, third.id(), heavy), found(Filter.ANY, new Sort(Column.LOAD, false)));
    assertEquals(List.of(third.id(), heavy, light), found(Filter.ANY, new Sort(Column.NAME, true)));
    assertEquals(
        List.of(third.id(), light, heavy), found(Filter.ANY, new Sort(Column.USER, false)));
    assertEquals(
        List.of(heavy, light, third.id()), found(Filter.ANY, new Sort(Column.STATE, false)));
    assertEquals(
        List.of(light, heavy, third.id()), found(Filter.ANY, new Sort(Column.CREATED, false)));
  }

  private static Filter text(String text) {
    return new Filter(Set.of(), null, null, text, null, null);
  }

  private List<Long> found(Filter filter) {
    List<Long> found = found(filter, Sort.NEWEST_FIRST);
    assertEquals(found.size(), store.count(filter));
    return found;
  }

  private List<Long> found(Filter filter, Sort sort) {
    List<Long> all = store.tasks(filter, sort, 0, 10).stream().map(TaskView::id).toList();
    assertEquals(
        all.stream().skip(1).limit(1).toList(),
        store.tasks(filter, sort, 1, 1).stream().map(TaskView::id).toList());
    return all;
  }

  private static TransportTask asked(String name, double load, String user, Instant at) {
    TaskPlace place = new TaskPlace(Vec2.ZERO, null);
    return new TransportTask(0, name, load, place, place, "lab", 0, null, null, user, at);
  }

  @Test
  void theLastDriveOfARobotComesBackExactly() {
    store.saveRobot(R1);
    assertEquals(Optional.empty(), store.drive("r1"));
    Trajectory way =
        new Trajectory(
            new Pose(0.1, 1 / 3.0, -3),
            List.of(new Segment(0.25, 0, 1.2), new Segment(0, 0.5, 0.1)));
    store.saveDrive("r1", new StoredDrive(4, null, 0, way));
    StoredDrive second = new StoredDrive(9, 77L, 2, way);
    store.saveDrive("r1", second);
    assertEquals(Optional.of(second), store.drive("r1"));
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

  private TransportTask added(TransportTask task) {
    return store.addTasks(List.of(new Submission(task, UUID.randomUUID()))).getFirst();
  }

  private static TransportTask task(String name) {
    TaskPlace start = new TaskPlace(new Vec2(1, 1), null);
    TaskPlace goal = new TaskPlace(new Vec2(2, 2), null);
    return new TransportTask(0, name, 1, start, goal, "lab", 0, null, null, "ann", AT);
  }
}
