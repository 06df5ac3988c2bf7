package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Margins;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveKind;
import org.toqa.sim.SimulatedFloor;

/** Tasks on a floor whose robots drive smooth curves where they meet nobody. */
@Tag("full")
@Timeout(200)
class SmoothFleetTest {
  private static final double SPEED = 100;
  private static final int COLUMNS = 40;
  private static final int ROWS = 24;
  private static final double CELL = 0.3;

  /** A hall of 12 m by 7.2 m with two blocks in it; goods cross from corner to corner. */
  private static final FloorMap HALL =
      new FloorMap(
          "hall",
          new FloorDrawing(
              walls(),
              List.of(
                  new Place("A", new Vec2(0.75, 6.45)),
                  new Place("B", new Vec2(11.25, 0.75)),
                  new Place("C", new Vec2(0.75, 0.75)),
                  new Place("D", new Vec2(11.25, 6.45))),
              List.of(
                  new Place("P1", new Vec2(0.45, 3.45)),
                  new Place("P2", new Vec2(11.55, 3.45)),
                  new Place("P3", new Vec2(6.15, 0.45))),
              List.of(),
              List.of(),
              List.of(),
              List.of(),
              Moves.SMOOTH),
          Margins.USUAL);

  @TempDir private Path folder;

  /** By robot: it was shown on a path with a straight that none of the eight headings has. */
  private final Set<String> onCurves = new TreeSet<>();

  private static OccupancyGrid walls() {
    BitSet occupied = new BitSet();
    for (int row = 9; row < 14; row++) {
      occupied.set(row * COLUMNS + 9, row * COLUMNS + 14);
      occupied.set(row * COLUMNS + 26, row * COLUMNS + 31);
    }
    return new OccupancyGrid(COLUMNS, ROWS, CELL, Vec2.ZERO, occupied);
  }

  /** {@link LiveFloor#close} judges whether bodies touched, where they truly were. */
  @ParameterizedTest
  @EnumSource(DriveKind.class)
  void robotsWhoseWaysCrossCarryTheirLoads(DriveKind kind) throws Exception {
    LiveFloor live = new LiveFloor(folder, HALL, SimulatedFloor.of(HALL), SPEED, kind);
    try {
      live.start();
      List<Long> tasks =
          List.of(
              live.submit(2, "A", "B"),
              live.submit(2, "C", "D"),
              live.submit(2, "B", "A"),
              live.submit(2, "D", "C"));
      live.await(
          view -> {
            view.robots().forEach(this::look);
            return tasks.stream().allMatch(id -> LiveFloor.isInState(view, id, TaskState.DONE));
          });
      assertTrue(onCurves.size() >= 2, onCurves::toString);
    } finally {
      live.close();
    }
  }

  private void look(RobotView robot) {
    List<Vec2> path = robot.pathPoints();
    boolean isOnCurve =
        IntStream.range(1, path.size())
            .mapToObj(i -> path.get(i).minus(path.get(i - 1)))
            .filter(leg -> leg.norm() > 0.25)
            .mapToDouble(leg -> leg.angle() / (Math.PI / 4))
            .anyMatch(eighths -> Math.abs(eighths - Math.rint(eighths)) > 0.05);
    if (isOnCurve) {
      onCurves.add(robot.name());
    }
  }

  @Test
  void aServerThatStartsAgainGoesOnWithTheCurveThatARobotDrives() throws Exception {
    int first = carryThroughARestart();
    assertEquals(first, carryThroughARestart(), "the same events give the same run");
  }

  /** The digest of all pictures of the run. */
  private int carryThroughARestart() throws Exception {
    try (FleetStage stage = new FleetStage(HALL)) {
      ScriptedRobot robot = stage.add("r1", new Vec2(0.45, 3.45), "P1");
      stage.restart();
      TaskOrder order =
          new TaskOrder(
              "box",
              1,
              new TaskOrder.Where.Station("A"),
              new TaskOrder.Where.Station("B"),
              null,
              0,
              null,
              null);
      Answer<TaskView> answer =
          stage.fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
      long task = ((Answer.Accepted<TaskView>) answer).value().id();
      Vec2 from = new Vec2(0.75, 6.45);
      stage.await(
          view -> {
            view.robots().forEach(this::look);
            return LiveFloor.isInState(view, task, TaskState.CARRYING)
                && robot.isDriving()
                && robot.position().distanceTo(from) > 3;
          });
      assertEquals(Set.of("r1"), onCurves);
      Vec2 at = robot.position();

      stage.restart();

      assertTrue(robot.isDriving(), "nobody told it to stop");
      double[] east = {at.x()};
      stage.await(
          view -> {
            double x = robot.position().x();
            assertTrue(x > east[0] - 0.01, () -> "it turned back at " + east[0] + " m");
            east[0] = Math.max(east[0], x);
            return robot.position().distanceTo(new Vec2(11.25, 0.75)) < 0.1;
          });
      stage.await(view -> LiveFloor.isInState(view, task, TaskState.DONE));
      return stage.digest();
    }
  }
}
