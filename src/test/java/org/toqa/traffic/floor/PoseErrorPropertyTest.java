package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Trajectory;
import org.toqa.testbed.Cases;

/** Robots that are as far beside their paths as a daemon lets them be touch nothing. */
@Tag("full")
class PoseErrorPropertyTest {
  private final Cases floors = new Cases("generated floors");

  /** Cells that are hardly larger than a robot: one is left between two; nobody goes to a wall. */
  @Property(tries = 10, seed = "20261123")
  void onNarrowCellsNoTwoRobotsTouch(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid hall =
        OccupancyGrid.parse(
            "............",
            "............",
            "............",
            "............",
            "............",
            "............",
            "............",
            "............");
    OccupancyGrid grid =
        new OccupancyGrid(
            hall.width(),
            hall.height(),
            0.26 + 0.1 * random.nextDouble(),
            Vec2.ZERO,
            hall.occupied());
    drive(grid, middles(grid, inner(grid)), 2 + random.nextInt(4), random, seed);
  }

  /** Aisles of one cell that is 0.1 m wider than a robot: there is room to keep off the walls. */
  @Property(tries = 10, seed = "20261123")
  void inAislesWithRoomNothingTouches(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid = FloorTrafficPropertyTest.aisles(random);
    List<Cell> free = FloorTrafficPropertyTest.largestPart(grid);
    drive(grid, middles(grid, free), 1 + random.nextInt(8), random, seed);
  }

  /** Aisles of 0.5 m on cells of 0.05 m, where lanes and paths could come nearer to the walls. */
  @Property(tries = 4, seed = "20261123")
  void onFineMapsWithRoomNothingTouches(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid coarse = FloorTrafficPropertyTest.aisles(random);
    int fine = 10;
    OccupancyGrid grid = FloorTrafficPropertyTest.finer(coarse, fine, 0.05, random);
    List<Vec2> places =
        FloorTrafficPropertyTest.largestPart(coarse).stream()
            .map(cell -> FloorTrafficPropertyTest.place(grid, coarse, cell, fine))
            .toList();
    drive(grid, places, 1 + random.nextInt(8), random, seed);
  }

  private static List<Cell> inner(OccupancyGrid grid) {
    return FloorTrafficPropertyTest.largestPart(grid).stream()
        .filter(cell -> cell.column() > 0 && cell.column() < grid.width() - 1)
        .filter(cell -> cell.row() > 0 && cell.row() < grid.height() - 1)
        .toList();
  }

  private void drive(OccupancyGrid grid, List<Vec2> places, int wanted, Random random, long seed) {
    List<Vec2> free = new ArrayList<>(places);
    int robots = Math.min(wanted, free.size() / 8);
    floors.count(robots > 0);
    if (robots == 0) {
      return;
    }
    Collections.shuffle(free, random);
    DrivenFloor floor = new DrivenFloor(grid, seed);
    for (int i = 0; i < robots; i++) {
      floor.putAt("r" + i, takeApart(free), DrivenFloor.DIAMETER);
    }
    floor.mostError = Trajectory.MAX_DEVIATION - 1e-3;
    for (int round = 0; round < 3; round++) {
      List<Vec2> goals = new ArrayList<>(places);
      Collections.shuffle(goals, random);
      for (int i = 0; i < robots; i++) {
        floor.sendTo("r" + i, takeApart(goals));
      }
      floor.drive(Duration.ofMinutes(20));
      assertTrue(
          floor.areAllArrived(),
          () ->
              floor.reasons()
                  + " on cells of "
                  + grid.resolution()
                  + "\n"
                  + String.join("\n", FloorTrafficPropertyTest.picture(grid)));
    }
  }

  private static List<Vec2> middles(OccupancyGrid grid, List<Cell> cells) {
    return cells.stream().map(grid::centre).toList();
  }

  /** The next of the places; those too near to it are taken out. */
  private static Vec2 takeApart(List<Vec2> places) {
    Vec2 place = places.removeFirst();
    places.removeIf(
        other -> other.distanceTo(place) < DrivenFloor.DIAMETER + 2 * Trajectory.MAX_DEVIATION);
    return place;
  }

  @AfterProperty
  void floorsHadRoomForRobots() {
    floors.assertPossible(0.8);
  }
}
