package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Reply;
import org.toqa.mission.TaskState;

/** Tasks that an operator cancels, in every state. */
class FleetCancelTest extends HallFleetTest {
  @Test
  void aTaskCancelledBeforeThePickUpEndsAndItsRobotGoesHome() throws Exception {
    long task = submit("East", "West");
    until(
        view -> task(view, task).state() == TaskState.TO_OBJECT && scriptedRobot("r1").isDriving());

    TaskView cancelled =
        accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));

    assertEquals(TaskState.CANCELLED, cancelled.state());
    until(
        view ->
            !scriptedRobot("r1").isDriving()
                && scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);
    assertEquals(List.of("Cancelled by Max"), history("task.cancelled"));
    assertEquals(TaskState.CANCELLED, stage.store.task(task).orElseThrow().state());
  }

  @Test
  void aQueuedTaskIsHeldAndCancelledWithoutARobot() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long task = submit("East", "West");

    assertTrue(accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Max"))).held());
    stage.restart(); // and it survives a restart
    accepted(stage.fleet.putInService("r1", "Max"));
    until(view -> robot(view, "r1").state() == RobotState.IDLE && task(view, task).held());
    assertEquals("On hold.", waitReason(stage.fleet.snapshots().latest(), task));
    TaskView cancelled =
        accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));

    assertEquals(TaskState.CANCELLED, cancelled.state());
    until(view -> task(view, task).state() == TaskState.CANCELLED);
    assertInstanceOf(
        Answer.Conflict.class, answer(stage.fleet.commandTask(task, new MissionEvent.Hold("Max"))));
  }

  @Test
  void withTheLoadOnBoardCancelAsksAndSetsItDownWhereTheRobotStops() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    Answer<TaskView> asked =
        answer(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));
    assertEquals(
        List.of("here", "back"),
        Objects.requireNonNull(assertInstanceOf(Answer.Conflict.class, asked).needs()).answers());
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE)));

    until(view -> task(view, task).state() == TaskState.CANCELLED);
    Vec2 place =
        Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).loadAt()).position();
    assertTrue(place.x() > 0.5 && place.x() < 8.5, "on the way: " + place);
    until(view -> scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);
    TaskView stored = stage.store.task(task).orElseThrow();
    assertEquals(0, Objects.requireNonNull(stored.loadAt()).position().distanceTo(place), 1e-9);
  }

  @Test
  void withTheLoadOnBoardCancelBringsItBack() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.BACK)));

    until(view -> task(view, task).state() == TaskState.CANCELLED);
    assertEquals(0, scriptedRobot("r1").position().distanceTo(new Vec2(0.5, 2.5)), 1e-6);
    until(
        view ->
            stage.store.history(task).stream().anyMatch(e -> e.text().equals("Returned to West")));
  }

  @Test
  void aGroupWithAMemberThatIsNotHeardStopsBeforeItsLoadIsLeftWhereItIsThen() throws Exception {
    long task = groupThatDrivesOnUnheard();

    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE)));

    assertSetDownInTheGroup(task);
  }

  @Test
  void aGroupWithAMemberThatIsNotHeardStopsWhenThePersonWhoIsAskedCancels() throws Exception {
    long task = groupThatDrivesOnUnheard();

    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.CANCEL)));

    assertSetDownInTheGroup(task);
  }

  /** It has come far since its member was heard last. */
  private long groupThatDrivesOnUnheard() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    List.of("r1", "r2").forEach(name -> scriptedRobot(name).setStepsPerSegment(30));
    long task = submit(orderForSeveral(8));
    until(view -> task(view, task).state() == TaskState.CARRYING && middle().x() > 6.6);
    List<String> team = task(stage.fleet.snapshots().latest(), task).robots();
    scriptedRobot(team.getLast()).loseServer();
    until(view -> task(view, task).needs() != null);
    double asked = middle().x();
    until(view -> middle().x() > asked + 0.5);
    assertTrue(scriptedRobot(team.getFirst()).isDriving());
    return task;
  }

  /** The robots stand on both sides of their load. */
  private Vec2 middle() {
    return scriptedRobot("r1").position().plus(scriptedRobot("r2").position()).times(0.5);
  }

  private void assertSetDownInTheGroup(long task) throws InterruptedException {
    until(view -> task(view, task).state() == TaskState.CANCELLED);
    Vec2 place =
        Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).loadAt()).position();
    assertEquals(0, place.distanceTo(middle()), 0.3);
    assertTrue(
        stage.store.history(task).stream().anyMatch(e -> e.text().startsWith("Set down at")),
        "it stopped first");
    List.of("r1", "r2").forEach(name -> scriptedRobot(name).findServer());
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    until(view -> scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);
    until(view -> scriptedRobot("r2").position().distanceTo(EAST) < 1e-6);
  }

  @Test
  void whatIsDeliveredIsNotCancelled() throws Exception {
    long task = submit("West", "East");
    until(view -> task(view, task).state() == TaskState.RETURNING);

    Answer<TaskView> no =
        answer(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE)));

    assertInstanceOf(Answer.Conflict.class, no);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aLoadThatWasSetDownIsDrivenRoundUntilSomebodySaysThatItIsGone() throws Exception {
    long task = cancelledOnTheWayEast();
    LeftLoad load = leftLoads().getFirst();
    assertEquals(task, load.task());
    until(view -> scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);
    stage.restart(); // and it is not forgotten
    until(view -> robot(view, "r1").state() == RobotState.IDLE && !leftLoads(view).isEmpty());

    long other = submit(new Where.Point(new Vec2(5.5, 1.5)), new Where.Point(new Vec2(13.5, 1.5)));
    until(
        view -> {
          assertNotEquals(GRID.cellAt(load.where()), GRID.cellAt(scriptedRobot("r1").position()));
          return task(view, other).state() == TaskState.DONE;
        });

    Instant ended = stage.store.task(task).orElseThrow().changedAt();
    accepted(stage.fleet.commandTask(task, new MissionEvent.RemoveLoad("Max")));
    until(view -> leftLoads(view).isEmpty());
    assertEquals(null, stage.store.task(task).orElseThrow().loadAt());
    assertEquals(ended, stage.store.task(task).orElseThrow().changedAt(), "it ended then");
    assertInstanceOf(
        Answer.Conflict.class,
        answer(stage.fleet.commandTask(task, new MissionEvent.RemoveLoad("Max"))));
    assertEquals(
        List.of("Max said that the load does not lie on the floor any more"),
        history("task.load-removed"));
  }

  @Test
  void aLoadThatWasSetDownIsFetchedForAnotherTask() throws Exception {
    long task = cancelledOnTheWayEast();
    until(view -> scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);

    long again = submit(new Where.Point(leftLoads().getFirst().where()), new Where.Station("East"));
    until(view -> task(view, again).state() == TaskState.DONE);

    assertEquals(List.of(), leftLoads());
    untilHistory(
        "task.load-fetched", "The load that was left on the floor was fetched for task " + again);
    assertEquals(null, stage.store.task(task).orElseThrow().loadAt());
  }

  @Test
  void aLoadStaysKnownWhoseTaskIsCancelledBeforeItIsFetchedAgain() throws Exception {
    long task = submit(new Where.Point(new Vec2(5.5, 1.5)), new Where.Point(new Vec2(13.5, 1.5)));
    until(view -> task(view, task).state() == TaskState.CARRYING && isPast(8));
    accepted(stage.fleet.takeOutOfService("r1", "Max")); // with the load on board
    until(view -> task(view, task).needs() != null);
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.ANOTHER)));
    until(view -> task(view, task).state() == TaskState.QUEUED);

    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));

    until(view -> leftLoads(view).size() == 1 && leftLoads(view).getFirst().task() == task);
  }

  /** Its load is on the floor between the ends of the task. */
  private long cancelledOnTheWayEast() throws Exception {
    long task = submit(new Where.Point(new Vec2(5.5, 1.5)), new Where.Point(new Vec2(13.5, 1.5)));
    until(view -> task(view, task).state() == TaskState.CARRYING && isPast(8));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE)));
    until(view -> task(view, task).state() == TaskState.CANCELLED && !leftLoads(view).isEmpty());
    return task;
  }

  private boolean isPast(double x) {
    return scriptedRobot("r1").isDriving() && scriptedRobot("r1").position().x() > x;
  }

  private List<LeftLoad> leftLoads() {
    return leftLoads(stage.fleet.snapshots().latest());
  }

  private static List<LeftLoad> leftLoads(FleetSnapshot view) {
    return view.floors().stream().flatMap(floor -> floor.leftLoads().stream()).toList();
  }
}
