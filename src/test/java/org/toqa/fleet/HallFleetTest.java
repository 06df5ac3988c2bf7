package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;

/** A fleet in a hall: the agents over a real store, with robots that the test plays. */
@Timeout(60)
abstract class HallFleetTest {
  /** Two rooms and one door between them, in cells of 1 m; (0, 0) is the lower left corner. */
  static final OccupancyGrid GRID =
      OccupancyGrid.parse(
          "....#..........", //
          "...............",
          "....#..........");

  static final Vec2 WEST = new Vec2(0.5, 0.5);
  static final Vec2 DOOR = new Vec2(4.5, 1.5);
  static final Vec2 EAST = new Vec2(8.5, 0.5);

  /** A few metres from r1, and more from the other end of the hall. */
  static final Where IN_THE_MIDDLE = new Where.Point(new Vec2(6.5, 2.5));

  static final FloorMap FLOOR =
      new FloorMap(
          "hall",
          GRID,
          List.of(new Place("West", new Vec2(0.5, 2.5)), new Place("East", new Vec2(8.5, 2.5))),
          List.of(new Place("P1", WEST), new Place("P2", EAST)),
          List.of());

  final FleetStage stage = new FleetStage(FLOOR);

  @BeforeEach
  void start() {
    stage.add("r1", WEST, "P1");
    stage.restart();
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  void untilCarryingOnTheWay(long task) throws InterruptedException {
    until(
        view ->
            task(view, task).state() == TaskState.CARRYING
                && scriptedRobot("r1").isDriving()
                && scriptedRobot("r1").position().distanceTo(new Vec2(0.5, 2.5)) > 0.9);
  }

  static <T> Answer<T> answer(CompletionStage<Answer<T>> answer) throws Exception {
    return answer.toCompletableFuture().get(10, TimeUnit.SECONDS);
  }

  void reopenWith(String name, Vec2 at, @Nullable String parking) {
    stage.add(name, at, parking);
    stage.restart();
  }

  void until(Predicate<FleetSnapshot> condition) throws InterruptedException {
    stage.await(condition);
  }

  /** What no answer waits for is written a moment later. */
  void untilHistory(String kind, String sentence) throws InterruptedException {
    until(view -> history(kind).equals(List.of(sentence)));
  }

  long submit(String start, String goal) throws Exception {
    return submit(new Where.Station(start), new Where.Station(goal));
  }

  /** From west to east. */
  static TaskOrder order(double load) {
    return new TaskOrder(
        "box", load, new Where.Station("West"), new Where.Station("East"), null, 0, null, null);
  }

  /** For several robots: within the east room, as the door is too narrow for them. */
  static TaskOrder orderForSeveral(double load) {
    return new TaskOrder(
        "box",
        load,
        new Where.Point(new Vec2(6.5, 1.5)),
        new Where.Point(new Vec2(11.5, 1.5)),
        null,
        0,
        null,
        null);
  }

  long submit(Where start, Where goal) throws Exception {
    return submit(new TaskOrder("box", 1, start, goal, null, 0, null, null));
  }

  long submit(TaskOrder order) throws Exception {
    long id = accepted(stage.fleet.submit(order, "Clara")).id();
    until(view -> view.tasks().stream().anyMatch(t -> t.id() == id));
    return id;
  }

  static <T> T accepted(CompletionStage<Answer<T>> pending) throws Exception {
    Answer<T> answer = pending.toCompletableFuture().get(10, TimeUnit.SECONDS);
    return answer instanceof Answer.Accepted<T>(T value) ? value : fail("No: " + answer);
  }

  ScriptedRobot scriptedRobot(String name) {
    return stage.scriptedRobot(name);
  }

  static RobotView robot(FleetSnapshot view, String name) {
    return view.robots().stream().filter(r -> r.name().equals(name)).findFirst().orElseThrow();
  }

  static TaskView task(FleetSnapshot view, long id) {
    return view.tasks().stream().filter(t -> t.id() == id).findFirst().orElseThrow();
  }

  static String waitReason(FleetSnapshot view, long task) {
    return Objects.toString(task(view, task).waitingFor(), "");
  }

  static CellRuns obstacles(FleetSnapshot view) {
    return view.floors().getFirst().obstacles();
  }

  static CellRuns cells(Cell cell) {
    BitSet bits = new BitSet();
    bits.set(GRID.index(cell));
    return CellRuns.of(bits);
  }

  List<String> history(String kind) {
    return stage
        .database
        .jdbi()
        .withHandle(
            h ->
                h.createQuery("select text from events where kind = :kind order by id")
                    .bind("kind", kind)
                    .mapTo(String.class)
                    .list());
  }
}
