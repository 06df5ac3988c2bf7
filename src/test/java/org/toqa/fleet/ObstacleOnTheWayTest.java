package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.DoubleAccumulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedFloor;

/** A real daemon finds something on its way that nobody has told it of. */
@Timeout(200)
class ObstacleOnTheWayTest {
  private static final double SPEED = 10;
  private static final double SIZE = 0.3;
  private static final double ROBOT = 0.255 / 2;

  /** Two rooms of cells of 0.3 m, and one door between them. */
  private static final String[] ROOMS = {
    "#########################",
    "#...........#...........#",
    "#...........#...........#",
    "#...........#...........#",
    "#.......................#",
    "#...........#...........#",
    "#...........#...........#",
    "#...........#...........#",
    "#########################",
  };

  @TempDir private Path folder;
  private LiveFloor live;

  /** Metres between the robot's rim and an obstacle at their nearest, as it truly is. */
  private final DoubleAccumulator nearest =
      new DoubleAccumulator(Math::min, Double.POSITIVE_INFINITY);

  @BeforeEach
  void open() throws Exception {
    OccupancyGrid drawn = OccupancyGrid.parse(ROOMS);
    OccupancyGrid grid =
        new OccupancyGrid(drawn.width(), drawn.height(), SIZE, Vec2.ZERO, drawn.occupied());
    FloorMap floor =
        new FloorMap(
            "hall",
            grid,
            List.of(new Place("A", cell(4, 4)), new Place("B", cell(21, 4))),
            List.of(new Place("P1", cell(2, 2))),
            List.of());
    live = new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED);
    live.start();
  }

  @AfterEach
  void close() throws Exception {
    live.close();
  }

  @Test
  void theRobotGoesRoundABoxThatItFindsOnItsWay() throws Exception {
    put(cell(8, 4), 0.15);

    long task = live.order(2, "A", "B");

    live.until(
        view ->
            !obstacles(view).equals(CellRuns.NONE)
                && view.robots().getFirst().errors().stream()
                    .anyMatch(fault -> fault.code().equals("OBSTACLE")));
    live.until(view -> LiveFloor.is(view, task, TaskState.DONE));
    assertTrue(nearest.get() > 0.02, "came as near as " + nearest);
    live.world.take("box");
    live.until(view -> obstacles(view).equals(CellRuns.NONE));
  }

  @Test
  void theRobotWaitsWhereThereIsNoWayRoundAndGoesOnWhenThereIs() throws Exception {
    put(cell(12, 4), 0.1);

    long task = live.order(2, "A", "B");

    live.until(
        view ->
            LiveFloor.is(view, task, TaskState.CARRYING)
                && String.valueOf(LiveFloor.task(view, task).waitingFor()).contains("an obstacle"));
    assertTrue(nearest.get() > 0.02, "came as near as " + nearest);
    live.world.take("box");
    live.until(view -> LiveFloor.is(view, task, TaskState.DONE));
  }

  /** Puts a round box, and watches how near the robot comes to it. */
  private void put(Vec2 middle, double radius) {
    live.world.put("box", middle, radius);
    live.clock.add(
        nanos ->
            live.robots
                .truth("r1")
                .map(truth -> truth.position().distanceTo(middle) - radius - ROBOT)
                .ifPresent(nearest::accumulate),
        Duration.ofMillis(20));
  }

  private static CellRuns obstacles(FleetSnapshot view) {
    return view.floors().getFirst().obstacles();
  }

  /** The middle of a cell, counted from below. */
  private static Vec2 cell(int column, int row) {
    return new Vec2((column + 0.5) * SIZE, (row + 0.5) * SIZE);
  }
}
