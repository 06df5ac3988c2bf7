package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveKind;
import org.toqa.sim.SimulatedFloor;

/**
 * A whole server with real daemons over bodies on two wheels, which {@link LiveFloor} judges where
 * they truly are.
 */
@Tag("full")
@Timeout(200)
class DifferentialFleetTest {
  private static final double SPEED = 200;
  private static final double SIZE = 0.3;

  /** Aisles of one cell round shelves, and a door: corners and turns on the spot. */
  private static final OccupancyGrid AISLES =
      OccupancyGrid.parse(
          "#################",
          "#.......#.......#",
          "#.#####.#.#####.#",
          "#.......#.......#",
          "#.#####...#####.#",
          "#.......#.......#",
          "#################");

  @TempDir private Path folder;

  @Test
  void robotsOnTwoWheelsCarryThroughAislesAndPastEachOther() throws Exception {
    FloorMap floor =
        new FloorMap(
            "aisles",
            new OccupancyGrid(AISLES.width(), AISLES.height(), SIZE, Vec2.ZERO, AISLES.occupied()),
            List.of(
                new Place("A", cell(1, 5)),
                new Place("B", cell(15, 1)),
                new Place("C", cell(15, 5)),
                new Place("D", cell(1, 1))),
            List.of(new Place("P1", cell(3, 3)), new Place("P2", cell(13, 3))),
            List.of());
    LiveFloor live =
        new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED, DriveKind.DIFFERENTIAL);
    try {
      live.start();
      long there = live.submit(2, "A", "B");
      long back = live.submit(2, "C", "D");
      FleetSnapshot view =
          live.await(
              v ->
                  LiveFloor.isInState(v, there, TaskState.DONE)
                      && LiveFloor.isInState(v, back, TaskState.DONE));
      assertEquals(
          List.of(DriveKind.DIFFERENTIAL, DriveKind.DIFFERENTIAL),
          view.robots().stream().map(r -> r.capabilities().kind()).toList());
    } finally {
      live.close();
    }
  }

  /** The middle of a cell, counted from below. */
  private static Vec2 cell(int column, int row) {
    return new Vec2((column + 0.5) * SIZE, (row + 0.5) * SIZE);
  }
}
