package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.Disc;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask.LoadSize;

/** Loads as things: each is the same one wherever it is, and in the way where it was set down. */
class FleetLoadsTest extends HallFleetTest {
  private static final Cell DOOR_CELL = GRID.cellAt(DOOR);
  private static final Vec2 EAST_OF_DOOR = DOOR.plus(new Vec2(1, 0));

  @Test
  void robotsWaitForALoadInTheOnlyDoorAlsoAfterTheServerWasKilled() throws Exception {
    setDownInTheDoor();

    stage.restart();
    long through = submit("West", "East");

    until(view -> waitReason(view, through).contains("an obstacle"));
    FleetSnapshot waiting = stage.fleet.snapshots().latest();
    assertTrue(waitReason(waiting, through).contains("(4.50, 1.50)"));
    assertTrue(
        waitReason(waiting, through)
            .contains("the load of task %d lies there".formatted(left().task())));
    accepted(stage.fleet.commandTask(left().task(), new MissionEvent.RemoveLoad("Max")));
    until(view -> task(view, through).state() == TaskState.DONE);
  }

  /** As a load that lies there; a delivered one is in nobody's way. */
  @Test
  void robotsWaitForABoxThatASupervisorSawInTheOnlyDoorUntilItIsCarried() throws Exception {
    stage.fleet.showBoxes("hall", List.of(new BoxView(7, DOOR, false)));
    long through = submit("West", "East");

    until(view -> waitReason(view, through).contains("box 7 lies there"));
    assertEquals(7, stage.fleet.snapshots().latest().floors().getFirst().boxes().getFirst().box());
    stage.fleet.showBoxes("hall", List.of(new BoxView(7, DOOR, true)));

    until(view -> task(view, through).state() == TaskState.DONE);
  }

  @Test
  void nobodyButWhoFetchesItDrivesToALoadThatLiesThere() throws Exception {
    setDownInTheDoor();
    reopenWith("r2", new Vec2(2.5, 0.5), "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));

    long fetching = submit(new Where.Point(place(left())), new Where.Station("East"));
    until(view -> !task(view, fetching).robots().isEmpty());
    long through = submit("West", "East");

    until(
        view -> {
          boolean isFetched =
              task(view, fetching).state() != TaskState.ASSIGNED
                  && task(view, fetching).state() != TaskState.TO_OBJECT;
          String fetcher = task(view, fetching).robots().getFirst();
          for (String other : List.of("r1", "r2")) {
            assertTrue(
                isFetched
                    || other.equals(fetcher)
                    || !DOOR_CELL.equals(GRID.cellAt(scriptedRobot(other).position())),
                other);
          }
          return task(view, fetching).state() == TaskState.DONE
              && task(view, through).state() == TaskState.DONE;
        });
  }

  @Test
  void aLoadStaysTheSameOneFromTaskToTask() throws Exception {
    long task = submit("West", "East");
    until(view -> load(view, task).robots().equals(List.of("r1")));
    assertEquals(null, load(stage.fleet.snapshots().latest(), task).place());
    setDownInTheDoor(task);
    LoadView left = left();
    assertEquals(task, left.id());
    assertTrue(left.isLeft());

    long again = submit(new Where.Point(place(left)), new Where.Station("East"));
    until(view -> Objects.equals(load(view, task).fetchedBy(), again));
    until(view -> task(view, again).state() == TaskState.CARRYING);

    LoadView carried = load(stage.fleet.snapshots().latest(), task);
    assertEquals(again, carried.task());
    assertTrue(carried.load().since().isAfter(left.load().since()));
    stage.restart();
    until(view -> task(view, again).state() == TaskState.RETURNING);
    assertEquals(
        new TaskPlace(new Vec2(8.5, 2.5), "East"),
        load(stage.fleet.snapshots().latest(), task).place());
    until(view -> LoadView.of(view).isEmpty());
  }

  @Test
  void aLoadIsMovedAsSoonAsTheServerIsThereAgain() throws Exception {
    setDownInTheDoor();
    long task = left().task();

    stage.restart();

    accepted(stage.fleet.commandTask(task, moved(EAST_OF_DOOR)));
    until(view -> place(left()).equals(EAST_OF_DOOR));
  }

  @Test
  void aLoadThatStandsOutFromItsRobotKeepsItsRoom() throws Exception {
    Vec2 start = new Vec2(6.5, 1.5);
    long task = submit(wide(new LoadSize(1.4, 1.0), new Where.Point(start)));
    until(
        view ->
            task(view, task).state() == TaskState.CARRYING
                && scriptedRobot("r1").position().x() > start.x() + 2);
    scriptedRobot("r1").fallSilent();

    until(view -> silentRobotCells(view).containsKey("r1"));
    Vec2 silent = scriptedRobot("r1").position();
    BitSet covered = new BitSet();
    new Disc(new LoadSize(1.4, 1.0).diameter() / 2 - 0.1)
        .cellsAt(GRID, silent)
        .forEach(cell -> covered.set(GRID.index(cell)));
    assertTrue(covered.cardinality() > 1);
    until(view -> keepsAll(view, covered));
    stage.restart();
    until(view -> keepsAll(view, covered));

    scriptedRobot("r1").speakAgain();
    until(view -> task(view, task).state() == TaskState.RETURNING);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aLoadTooWideForTheDoorIsRefused() throws Exception {
    TaskOrder order = wide(new LoadSize(0.9, 0.8), new Where.Station("West"));

    Answer.Rejected<?> refused =
        assertInstanceOf(Answer.Rejected.class, answer(stage.fleet.submit(order, "Clara")));

    assertEquals("load", refused.field());
    assertEquals(
        "There is no path from West to (13.50, 1.50) for a load of 0.90 m x 0.80 m on one robot:"
            + " it needs 1.20 m wherever it turns.",
        refused.sentence().english());
    submit(wide(new LoadSize(0.6, 0.6), new Where.Station("West")));
  }

  /** To the other end of the east room. */
  private static TaskOrder wide(LoadSize size, Where start) {
    Where goal = new Where.Point(new Vec2(13.5, 1.5));
    return new TaskOrder("crate", 1, start, goal, null, 0, null, size);
  }

  private static boolean keepsAll(FleetSnapshot view, BitSet cells) {
    BitSet free = (BitSet) cells.clone();
    List<Integer> kept = silentRobotCells(view).getOrDefault("r1", CellRuns.NONE).runs();
    for (int i = 0; i < kept.size(); i += 2) {
      free.clear(kept.get(i), kept.get(i) + kept.get(i + 1));
    }
    return free.isEmpty();
  }

  private static Map<String, CellRuns> silentRobotCells(FleetSnapshot view) {
    return view.floors().isEmpty() ? Map.of() : view.floors().getFirst().silentRobotCells();
  }

  @Test
  void aLoadOfAnotherWeightIsFetchedOnceWhatLiesThereIsGone() throws Exception {
    setDownInTheDoor();
    LoadView left = left();

    TaskOrder small =
        new TaskOrder(
            "Small box",
            left.weight() / 2,
            new Where.Point(place(left)),
            new Where.Station("East"),
            null,
            0,
            null,
            null);
    long task = submit(small);

    until(
        view ->
            waitReason(view, task)
                .contains("the load of task %d lies there".formatted(left.task())));
    assertEquals(left, left());
    accepted(stage.fleet.commandTask(left.task(), new MissionEvent.RemoveLoad("Max")));
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aLoadLiesWhereAPersonSaysAndTheRobotThatStandsThereGetsOut() throws Exception {
    setDownInTheDoor();
    long task = left().task();

    assertInstanceOf(
        Answer.Rejected.class, answer(stage.fleet.commandTask(task, moved(new Vec2(4.5, 0.5)))));
    accepted(stage.fleet.commandTask(task, moved(scriptedRobot("r1").position())));
    until(view -> scriptedRobot("r1").position().distanceTo(place(left())) < 0.01);
    long other = submit("East", "West");

    until(view -> task(view, other).state() == TaskState.DONE || isPast(6));
    assertEquals(
        "Max said that the load lies at (0.50, 0.50) now", history("task.load-moved").getLast());
    assertFalse(LoadView.of(stage.fleet.snapshots().latest()).isEmpty());
  }

  @Test
  void aRobotThatTakesItselfToBeBesideTheMapKeepsNobodyFromDriving() throws Exception {
    setDownInTheDoor();
    reopenWith("r2", new Vec2(6.5, 0.5), "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    scriptedRobot("r1").shove(new Vec2(-20, 2));

    long task = submit(IN_THE_MIDDLE, new Where.Station("East"));

    until(view -> task(view, task).state() == TaskState.DONE);
  }

  private static MissionEvent.MoveLoad moved(Vec2 where) {
    return new MissionEvent.MoveLoad("Max", new TaskPlace(where, null));
  }

  private void setDownInTheDoor() throws Exception {
    setDownInTheDoor(submit("West", "East"));
  }

  private void setDownInTheDoor(long task) throws Exception {
    until(view -> task(view, task).state() == TaskState.CARRYING && isPast(3));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE)));
    until(view -> task(view, task).state() == TaskState.CANCELLED);
    until(view -> LoadView.of(view).stream().anyMatch(LoadView::isLeft));
    until(view -> scriptedRobot("r1").position().distanceTo(WEST) < 1e-6); // it got off it
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.commandTask(task, moved(DOOR)));
    until(view -> place(left()).equals(DOOR));
  }

  private boolean isPast(double x) {
    return scriptedRobot("r1").isDriving() && scriptedRobot("r1").position().x() > x;
  }

  private static Vec2 place(LoadView load) {
    return Objects.requireNonNull(load.place()).position();
  }

  private LoadView left() {
    return LoadView.of(stage.fleet.snapshots().latest()).stream()
        .filter(LoadView::isLeft)
        .findFirst()
        .orElseThrow();
  }

  private static LoadView load(FleetSnapshot view, long id) {
    return LoadView.of(view).stream().filter(load -> load.id() == id).findFirst().orElseThrow();
  }
}
