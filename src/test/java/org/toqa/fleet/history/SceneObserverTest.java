package org.toqa.fleet.history;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.traffic.floor.RemainingPath;

class SceneObserverTest {
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00Z");
  private static final Vec2 START = new Vec2(1, 1);
  private static final Vec2 GOAL = new Vec2(9, 1);
  private static final List<FloorView> HALL = List.of(Views.floorWith("hall", List.of()));

  private final SceneObserver observer = new SceneObserver(List.of(), List.of());

  @Test
  void aLoadIsFollowedFromItsOrderToWhereItIsNobodysAnyMore() {
    observe(0, List.of(), task(TaskState.QUEUED));
    observe(1, List.of(), task(TaskState.TO_OBJECT, "r1")); // where it was
    observe(2, List.of(), task(TaskState.CARRYING, "r1"));
    observe(3, List.of(), task(TaskState.CARRYING, "r2", "r1"));
    observe(4, List.of(), task(TaskState.RETURNING, "r2", "r1"));
    observe(5, List.of());

    assertEquals(
        List.of(
            load(0, 2L, START),
            load(2, 3L, null, "r1"),
            load(3, 4L, null, "r2", "r1"),
            load(4, 5L, GOAL)),
        observer.changes().loads());
  }

  @Test
  void theRestOfAPathIsTheSamePathAndAnotherOneIsNot() {
    observe(0, List.of(robot(1, 5, 9)));
    observe(1, List.of(robot(3, 5, 9)));
    observe(2, List.of(robot(5.0001, 9))); // a point was passed
    observe(3, List.of(robot(6, 8))); // leads elsewhere now
    observe(4, List.of(robot(8)));

    assertEquals(List.of(path(0, 3L, 1, 5, 9), path(3, 4L, 6, 8)), observer.changes().paths());
  }

  @Test
  void whatWasStoredIsToldAgainOnlyWithItsEnd() {
    observe(0, List.of(robot(1, 9)), task(TaskState.QUEUED));
    assertEquals(List.of(load(0, null, START)), observer.changes().loads());
    assertEquals(List.of(path(0, null, 1, 9)), observer.changes().paths());
    observer.forgetChanges();
    observe(1, List.of(robot(2, 9)), task(TaskState.QUEUED));
    assertTrue(observer.changes().isEmpty());

    observe(2, List.of());

    assertEquals(List.of(load(0, 2L, START)), observer.changes().loads());
    assertEquals(List.of(path(0, 2L, 1, 9)), observer.changes().paths());
  }

  /** While a server starts, or another map comes in force, its floors have not reported. */
  @Test
  void aFloorThatHasNotReportedIsLeftAsItWas() {
    SceneObserver restarted =
        new SceneObserver(List.of(load(-9, null, START)), List.of(path(-9, null, 1, 9)));
    restarted.observe(FleetSnapshot.initial(AT, null));
    assertTrue(restarted.changes().isEmpty());

    restarted.observe(snapshot(7, List.of(robot(4, 9)), List.of(task(TaskState.QUEUED))));
    assertTrue(restarted.changes().isEmpty());
    restarted.observe(snapshot(8, List.of(), List.of()));

    assertEquals(List.of(load(-9, 8L, START)), restarted.changes().loads());
    assertEquals(List.of(path(-9, 8L, 1, 9)), restarted.changes().paths());
  }

  @Test
  void aPathIsStoredWithAsFewPointsAsShowIt() {
    PlannedPath path =
        new PlannedPath(
            "r1",
            "hall",
            AT,
            null,
            List.of(new Vec2(1, 1), new Vec2(2, 1.01), new Vec2(3, 1), new Vec2(3, 4)));

    assertEquals(
        List.of(new Vec2(1, 1), new Vec2(3, 1), new Vec2(3, 4)), path.simplified().points());
  }

  private void observe(long second, List<RobotView> robots, TaskView... tasks) {
    observer.observe(snapshot(second, robots, List.of(tasks)));
  }

  private static FleetSnapshot snapshot(long second, List<RobotView> robots, List<TaskView> tasks) {
    return new FleetSnapshot(
        second,
        AT.plusSeconds(second),
        robots,
        tasks,
        0,
        HALL,
        null,
        Map.of(),
        Map.of(),
        List.of());
  }

  private static TaskView task(TaskState state, String... robots) {
    TransportTask task =
        new TransportTask(
            7,
            "box",
            1,
            new TaskPlace(START, null),
            new TaskPlace(GOAL, null),
            "hall",
            0,
            null,
            null,
            "Max",
            AT);
    return Views.task(task, state, false, List.of(robots), null, null, false, null, null, AT);
  }

  /** At the first x, with the rest ahead on y = 1. */
  private static RobotView robot(double... xs) {
    RobotView robot =
        Hall.robot("r1", RobotState.DRIVING, new Pose(xs[0], 1, 0), "127.0.0.1", 7275);
    return robot.withPath(new RemainingPath(points(xs), 1, null));
  }

  private static List<Vec2> points(double... xs) {
    return Arrays.stream(xs).mapToObj(x -> new Vec2(x, 1)).toList();
  }

  private static LoadPlace load(
      long from, @Nullable Long until, @Nullable Vec2 position, String... robots) {
    return new LoadPlace(
        7,
        7,
        "hall",
        AT.plusSeconds(from),
        until == null ? null : AT.plusSeconds(until),
        position,
        List.of(robots),
        null);
  }

  private static PlannedPath path(long from, @Nullable Long until, double... xs) {
    return new PlannedPath(
        "r1",
        "hall",
        AT.plusSeconds(from),
        until == null ? null : AT.plusSeconds(until),
        points(xs));
  }
}
