package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.fleet.TaskArchive.Sort.Column;
import org.toqa.fleet.TaskTraces;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/** What every database must find of past tasks; here H2, in {@code MySqlTaskArchiveTest} MySQL. */
class TaskArchiveTest extends FleetDatabaseTest {
  @Test
  void endedTasksAreOnlyInTheArchive() {
    store.saveRobot(R1);
    TransportTask first = added(task("first"));
    TransportTask second = added(task("second"));
    store.saveMission(
        new Mission(
            first,
            TaskState.DONE,
            List.of(new AssignedRobot("r1", Phase.HOME, true, true)),
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
        List.of(third.id(), light),
        found(new Filter(Set.of(), null, "ANN", null, null, null, null)));
    assertEquals(
        List.of(third.id()), found(new Filter(Set.of(), "r1", null, null, null, null, null)));
    assertEquals(
        List.of(heavy, light),
        found(
            new Filter(
                Set.of(TaskState.QUEUED, TaskState.DONE), null, null, null, null, null, null)));
    assertEquals(
        List.of(heavy),
        found(
            new Filter(Set.of(), null, null, null, AT.plusSeconds(60), AT.plusSeconds(120), null)));
    assertEquals(List.of(), found(new Filter(Set.of(), "r2", "ann", "box", AT, null, null)));
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

  @Test
  void tasksAreFollowedByEachUserOnHisOwnUntilTheyAreDeleted() {
    JdbiAccountStore accounts =
        new JdbiAccountStore(database.jdbi(), () -> AT, new LastKnownUsers());
    long ann = accounts.add("ann", "hash", Role.CLERK, "Max").orElseThrow().id();
    long max = accounts.add("max", "hash", Role.MANAGER, "Max").orElseThrow().id();
    TaskTraces traces = new JdbiTaskTraces(database.jdbi(), () -> AT);
    TransportTask first = added(task("first"));
    long second = added(task("second")).id();

    traces.setFollowed(ann, first.id(), true);
    traces.setFollowed(ann, first.id(), true);
    traces.setFollowed(max, second, true);
    traces.setFollowed(max, 999_999, true);

    assertTrue(traces.isFollowed(ann, first.id()));
    assertFalse(traces.isFollowed(ann, second));
    assertFalse(traces.isFollowed(max, 999_999), "there is no such task");
    assertEquals(List.of(first.id()), found(followedBy(ann)));
    traces.setFollowed(max, second, false);
    assertEquals(List.of(), found(followedBy(max)));

    EventRecord deleted =
        new EventRecord(
            AT, EventKind.TASK_DELETED, first.id(), null, "Max", Sentence.verbatim("gone"));
    assertFalse(store.deleteTask(first.id(), deleted), "it waits");
    store.saveMission(
        new Mission(first, TaskState.DONE, List.of(), false, null, null, null), AT, List.of());
    assertTrue(store.deleteTask(first.id(), deleted));
    assertFalse(store.deleteTask(first.id(), deleted), "it is gone");
    assertEquals(List.of(), found(followedBy(ann)));
    assertEquals(deleted, store.history(first.id()).getLast());
    new HistoryPruner(database.jdbi()).pruneHistory(AT.plusSeconds(1));
    assertEquals(List.of(), store.history(first.id()), "its events are as old as others");
    assertEquals(1, store.history(second).size(), "those of a task that waits stay");
  }

  @Test
  void aNameHasRoomForLettersOfTwoCharacters() {
    String name = "\ud83e\udd16".repeat(100);
    assertEquals(name, store.task(added(task(name)).id()).orElseThrow().task().name());
  }

  @Test
  void aTaskWhoseLoadLiesOnTheFloorIsNotDeleted() {
    TransportTask task = added(task("left"));
    TaskPlace place = new TaskPlace(new Vec2(1, 1), null);
    store.saveMission(
        new Mission(task, TaskState.CANCELLED, List.of(), false, null, place, null), AT, List.of());

    assertFalse(
        store.deleteTask(
            task.id(),
            new EventRecord(
                AT, EventKind.TASK_DELETED, task.id(), null, "Max", Sentence.verbatim("gone"))));
    assertTrue(store.task(task.id()).isPresent());
  }

  @Test
  void aTaskWhoseLoadLiesOnTheFloorIsKeptUntilThatIsTakenAway() {
    TransportTask task = added(task("left"));
    HistoryPruner pruner = new HistoryPruner(database.jdbi());
    TaskPlace place = new TaskPlace(new Vec2(1, 1), null);
    store.saveMission(
        new Mission(task, TaskState.CANCELLED, List.of(), false, null, place, null), AT, List.of());

    assertEquals(0, pruner.pruneHistory(AT.plusSeconds(1)));
    assertTrue(store.task(task.id()).isPresent());
    store.saveMission(
        new Mission(task, TaskState.CANCELLED, List.of(), false, null, null, null), AT, List.of());

    assertEquals(1, pruner.pruneHistory(AT.plusSeconds(1)));
    assertEquals(Optional.empty(), store.task(task.id()));
  }

  @Test
  void whatIsOrderedOfATaskIsStoredWithIt() {
    TransportTask task = added(task("first"));
    TransportTask order =
        new TransportTask(
            0,
            "other",
            7.5,
            new TaskPlace(new Vec2(1, 2), "A"),
            new TaskPlace(new Vec2(3, 4), null),
            "hall",
            5,
            AT.plusSeconds(90),
            new TransportTask.LoadSize(0.4, 0.6),
            "Max",
            AT.plusSeconds(9));
    Mission edited =
        Mission.queued(task).apply(new MissionEvent.Edit("Max", order, null)).mission();

    store.saveMission(edited, AT, List.of());

    TransportTask stored = store.task(task.id()).orElseThrow().task();
    assertEquals(edited.task(), stored);
    assertTrue(stored.isOrderedAs(order));
    assertEquals(task.createdAt(), stored.createdAt());
  }

  private static Filter followedBy(long user) {
    return new Filter(Set.of(), null, null, null, null, null, user);
  }

  private static Filter text(String text) {
    return new Filter(Set.of(), null, null, text, null, null, null);
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
}
