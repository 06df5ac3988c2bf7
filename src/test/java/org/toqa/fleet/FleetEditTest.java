package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;

/** Waiting tasks are edited, ended ones are deleted. */
class FleetEditTest extends HallFleetTest {
  private static final TaskOrder BACK =
      new TaskOrder(
          "crate", 2, new Where.Station("East"), new Where.Station("West"), null, 3, null, null);

  private void keepWaiting() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
  }

  @Test
  void aWaitingTaskIsEditedAndDrivenAsItIsOrderedThenAlsoAfterARestart() throws Exception {
    keepWaiting();
    TaskView before = accepted(stage.fleet.submit(order(1), "Clara"));

    TaskView edited = accepted(stage.fleet.editTask(before.id(), BACK, before.task(), "Max"));

    assertTrue(
        task(stage.fleet.snapshots().latest(), before.id()).task().isOrderedAs(edited.task()),
        "whoever looks after the answer sees it");
    assertEquals("crate", edited.task().name());
    assertEquals(2, edited.task().load());
    assertEquals("Clara", edited.task().user(), "whose it was");
    assertEquals(before.task().createdAt(), edited.task().createdAt());
    EventRecord told = stage.store.history(before.id()).getLast();
    assertEquals("task.edited", told.kind());
    assertEquals("Max", told.who());
    assertEquals("Max edited the order; it was: box, 1 kg, West to East, priority 0", told.text());
    stage.restart();
    until(view -> view.queuedCount() == 1);
    assertTrue(
        task(stage.fleet.snapshots().latest(), before.id()).task().isOrderedAs(edited.task()));
    accepted(stage.fleet.putInService("r1", "Max"));
    until(view -> task(view, before.id()).state() == TaskState.CARRYING);
    assertEquals(
        "East", task(stage.fleet.snapshots().latest(), before.id()).task().start().station());
  }

  @Test
  void anEditOfWhatAnotherHasEditedSinceItWasSeenChangesNothing() throws Exception {
    keepWaiting();
    TaskView seen = accepted(stage.fleet.submit(order(1), "Clara"));
    accepted(stage.fleet.editTask(seen.id(), BACK, seen.task(), "Max"));

    assertInstanceOf(
        Answer.Outdated.class,
        answer(stage.fleet.editTask(seen.id(), order(3), seen.task(), "Clara")));
    assertEquals(2, stage.store.task(seen.id()).orElseThrow().task().load());
    accepted(stage.fleet.editTask(seen.id(), BACK, null, "Clara"));
    assertEquals(1, kinds(seen.id(), "task.edited"), "nothing was changed the second time");
  }

  @Test
  void anEditIsCheckedAsANewOrderIs() throws Exception {
    keepWaiting();
    long task = accepted(stage.fleet.submit(order(1), "Clara")).id();

    Answer<TaskView> tooHeavy = answer(stage.fleet.editTask(task, order(1000), null, "Clara"));

    assertEquals("load", assertInstanceOf(Answer.Rejected.class, tooHeavy).field());
    assertEquals(1, stage.store.task(task).orElseThrow().task().load());
  }

  @Test
  void aTaskThatRobotsHaveIsNotEditedAndNotDeleted() throws Exception {
    long id = submit(order(1));
    until(view -> !task(view, id).robots().isEmpty());

    assertEquals(
        new Answer.Conflict<>(Phrase.TASK_WAITS_NO_MORE.with(id), null),
        answer(stage.fleet.editTask(id, BACK, null, "Clara")));
    assertEquals(
        new Answer.Conflict<>(Phrase.TASK_HAS_NOT_ENDED.with(id), null),
        answer(stage.fleet.deleteTask(stage.store.task(id).orElseThrow(), "Clara")));
    assertEquals(1, stage.store.task(id).orElseThrow().task().load());
  }

  @Test
  void anEndedTaskIsDeletedAndItsHistoryStays() throws Exception {
    keepWaiting();
    long id = submit(order(1));
    TaskView waiting = task(stage.fleet.snapshots().latest(), id);
    assertInstanceOf(Answer.Conflict.class, answer(stage.fleet.deleteTask(waiting, "Clara")));
    TaskView ended = accepted(stage.fleet.commandTask(id, new MissionEvent.Cancel("Clara", null)));

    accepted(stage.fleet.deleteTask(ended, "Max"));

    assertTrue(stage.fleet.snapshots().latest().tasks().stream().noneMatch(t -> t.id() == id));
    assertTrue(stage.store.task(id).isEmpty());
    EventRecord told = stage.store.history(id).getLast();
    assertEquals("task.deleted", told.kind());
    assertEquals("Max deleted the task box", told.text());
    assertEquals(
        new Answer.Unknown<>(Phrase.TASK_WAS_DELETED_BEFORE.with(id)),
        answer(stage.fleet.deleteTask(ended, "Max")),
        "twice");
    assertEquals(1, kinds(id, "task.deleted"));
  }

  private long kinds(long task, String kind) {
    List<EventRecord> history = stage.store.history(task);
    return history.stream().filter(event -> event.kind().equals(kind)).count();
  }
}
