package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.Supplier;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.testbed.Cases;
import org.toqa.traffic.RoadGraph;

class FloorTrafficPropertyTest {
  private final Cases floors = new Cases("generated floors");

  /**
   * Random floors with one-cell aisles, dead ends and crossings: every robot reaches three goals in
   * turn; {@link DrivenFloor} sees to it that none ever touch.
   */
  @Property(tries = 13, seed = "20261121")
  void onRandomFloorsEveryRobotArrives(@ForAll @LongRange(min = 0) long seed) {
    floors.count(driveToThreeGoals(seed));
  }

  @AfterProperty
  void floorsHadRoomForRobots() {
    floors.assertPossible(0.9);
  }

  /** Whether there was room for robots; the floors of the other kinds answer the same. */
  static boolean driveToThreeGoals(long seed) {
    return driveToThreeGoals(seed, Moves.HEADING);
  }

  static boolean driveToThreeGoals(long seed, Moves moves) {
    Random random = new Random(seed);
    OccupancyGrid grid = withAreas(aisles(random), seed);
    List<Cell> free = largestPart(grid);
    int robots = Math.min(1 + random.nextInt(8), free.size() / 4);
    if (robots < 1) {
      return false;
    }
    DrivenFloor floor = floorWithRobots(grid, moves, free, robots, random, seed);
    for (int round = 0; round < 3; round++) {
      Collections.shuffle(free, random);
      for (int i = 0; i < robots; i++) {
        floor.send("r" + i, random.nextInt(5) == 0 ? null : free.get(i));
      }
      floor.drive(Duration.ofMinutes(20));
      requireArrivals(floor, robots, grid, () -> String.join("\n", picture(grid)));
    }
    return true;
  }

  /**
   * All have arrived. With one-way areas not every set of goals can be reached at once: those who
   * have not arrived then are told why, and each arrives when the others want nothing.
   */
  private static void requireArrivals(
      DrivenFloor floor, int robots, OccupancyGrid grid, Supplier<String> picture) {
    Map<String, String> reasons = floor.reasons();
    if (floor.areAllArrived()) {
      return;
    }
    assertTrue(grid.rules().isDirected(), () -> reasons + " on\n" + picture.get());
    Map<String, Vec2> goals = new TreeMap<>();
    for (int i = 0; i < robots; i++) {
      String robot = "r" + i;
      Vec2 goal = floor.body(robot).goal;
      if (reasons.containsKey(robot) && goal != null) {
        goals.put(robot, goal);
      }
      floor.sendTo(robot, null);
    }
    goals.forEach(
        (robot, goal) -> {
          floor.sendTo(robot, goal);
          floor.drive(Duration.ofMinutes(20));
          assertTrue(
              floor.areAllArrived(),
              () -> "alone " + floor.reasons() + ", before " + reasons + " on\n" + picture.get());
          floor.sendTo(robot, null);
        });
  }

  /** A floor with the robots r0, r1 ..., which are at the first places after a shuffle. */
  private static DrivenFloor floorWithRobots(
      OccupancyGrid grid, Moves moves, List<Cell> free, int robots, Random random, long seed) {
    Collections.shuffle(free, random);
    DrivenFloor floor = new DrivenFloor(grid, moves, seed);
    for (int i = 0; i < robots; i++) {
      floor.put("r" + i, free.get(i));
    }
    return floor;
  }

  /** Robots that were stopped anywhere go on from there: off the middle, in any heading. */
  @Property(tries = 8, seed = "20261121")
  void fromWhereverItStandsARobotArrives(@ForAll @LongRange(min = 0) long seed) {
    floors.count(driveFromAnywhere(seed));
  }

  static boolean driveFromAnywhere(long seed) {
    return driveFromAnywhere(seed, Moves.HEADING);
  }

  static boolean driveFromAnywhere(long seed, Moves moves) {
    Random random = new Random(seed);
    OccupancyGrid coarse = aisles(random);
    List<Cell> free = largestPart(coarse);
    if (free.size() < 8) {
      return false;
    }
    int fine = random.nextBoolean() ? 1 : 3 + random.nextInt(4);
    OccupancyGrid grid =
        fine == 1
            ? withAreas(coarse, seed)
            : withAreas(coarse, finer(coarse, fine, DrivenFloor.CELL / fine, random), fine, seed);
    double diameter = 0.2 + 0.18 * random.nextDouble(); // 2 cm less than the narrowest aisle
    for (int i = 0; i < 20; i++) {
      Collections.shuffle(free, random);
      Vec2 goal = place(grid, coarse, free.getFirst(), fine);
      Vec2 middle = place(grid, coarse, free.getLast(), fine);
      Vec2 start;
      do {
        start =
            new Vec2(
                middle.x() + DrivenFloor.CELL * (random.nextDouble() - 0.5),
                middle.y() + DrivenFloor.CELL * (random.nextDouble() - 0.5));
      } while (!isClearOfWalls(grid, start, diameter / 2));
      Pose pose = new Pose(start.x(), start.y(), 2 * Math.PI * random.nextDouble());
      DrivenFloor floor = new DrivenFloor(grid, moves, seed);
      floor.putAt("a", pose, diameter);
      floor.sendTo("a", goal);
      floor.drive(Duration.ofMinutes(5));
      assertTrue(
          floor.areAllArrived(),
          () ->
              floor.reasons()
                  + " "
                  + diameter
                  + " at "
                  + pose
                  + " fine "
                  + fine
                  + " on\n"
                  + String.join("\n", picture(grid)));
    }
    return true;
  }

  private static boolean isClearOfWalls(OccupancyGrid grid, Vec2 point, double radius) {
    int reach = (int) Math.ceil(radius / grid.resolution());
    Cell here = grid.cellAt(point);
    for (int row = here.row() - reach; row <= here.row() + reach; row++) {
      for (int column = here.column() - reach; column <= here.column() + reach; column++) {
        if (!grid.isFree(column, row)
            && Disc.distanceToCell(grid, point, new Cell(column, row)) < radius + 1e-6) {
          return false;
        }
      }
    }
    return true;
  }

  /** Floors whose cells are far smaller than a robot, which may be anywhere, and of any size. */
  @Property(tries = 3, seed = "20261121")
  void onFineMapsEveryRobotArrives(@ForAll @LongRange(min = 0) long seed) {
    floors.count(driveOnAFineMap(seed));
  }

  static boolean driveOnAFineMap(long seed) {
    return driveOnAFineMap(seed, Moves.HEADING);
  }

  static boolean driveOnAFineMap(long seed, Moves moves) {
    Random random = new Random(seed);
    OccupancyGrid coarse = aisles(random);
    int fine = 8 + random.nextInt(5);
    OccupancyGrid grid = withAreas(coarse, finer(coarse, fine, 0.05, random), fine, seed);
    List<Cell> free = largestPart(coarse);
    int robots = Math.min(1 + random.nextInt(8), free.size() / 4);
    if (robots < 1) {
      return false;
    }
    DrivenFloor floor = new DrivenFloor(grid, moves, seed);
    Collections.shuffle(free, random);
    for (int i = 0; i < robots; i++) {
      floor.putAt("r" + i, place(grid, coarse, free.get(i), fine), DrivenFloor.DIAMETER);
    }
    for (int round = 0; round < 3; round++) {
      Collections.shuffle(free, random);
      for (int i = 0; i < robots; i++) {
        floor.sendTo(
            "r" + i, random.nextInt(5) == 0 ? null : place(grid, coarse, free.get(i), fine));
      }
      floor.drive(Duration.ofMinutes(20));
      requireArrivals(
          floor, robots, grid, () -> "fine " + fine + "\n" + String.join("\n", picture(coarse)));
    }
    return true;
  }

  /** The middle of a coarse cell on the finer grid. */
  static Vec2 place(OccupancyGrid grid, OccupancyGrid coarse, Cell cell, int fine) {
    double left = (grid.width() - coarse.width() * fine) * grid.resolution();
    double side = fine * grid.resolution();
    return new Vec2(
        left + (cell.column() + 0.5) * side, (coarse.height() - cell.row() - 0.5) * side);
  }

  /** Goals change while all drive; robots stop for a while and go on, and some are lost. */
  @Property(tries = 5, seed = "20261121")
  void newGoalsStopsAndLossesDisturbNothing(@ForAll @LongRange(min = 0) long seed) {
    floors.count(driveThroughTroubles(seed));
  }

  static boolean driveThroughTroubles(long seed) {
    return driveThroughTroubles(seed, Moves.HEADING);
  }

  static boolean driveThroughTroubles(long seed, Moves moves) {
    Random random = new Random(seed);
    OccupancyGrid grid = withAreas(aisles(random), seed);
    List<Cell> free = largestPart(grid);
    int robots = Math.min(2 + random.nextInt(6), free.size() / 4);
    if (robots < 1) {
      return false;
    }
    DrivenFloor floor = floorWithRobots(grid, moves, free, robots, random, seed);
    for (int i = 0; i < robots; i++) {
      floor.send("r" + i, free.get(free.size() - 1 - i));
    }
    for (int step = 0; step < 1500; step++) {
      String robot = "r" + random.nextInt(robots);
      if (random.nextInt(40) == 0 && floor.isArrived(robot)) {
        floor.send(robot, free.get(random.nextInt(free.size())));
      }
      if (random.nextInt(60) == 0) {
        floor.body(robot).isStuck ^= true;
      }
      if (random.nextInt(500) == 0) {
        floor.lose(robot);
      }
      if (random.nextInt(250) == 0) {
        floor.find(robot);
      }
      floor.step();
    }
    floor.bodies.values().forEach(b -> b.isStuck = false);
    for (int i = 0; i < robots; i++) {
      if (floor.isArrived("r" + i)) {
        floor.send("r" + i, free.get(i));
      }
    }
    floor.driveWhileAnyMoves(Duration.ofMinutes(2));
    if (grid.rules().isDirected()) { // one that is lost may cut off others
      for (int i = 0; i < robots; i++) {
        floor.find("r" + i);
      }
      floor.drive(Duration.ofMinutes(20));
      requireArrivals(floor, robots, grid, () -> String.join("\n", picture(grid)));
      return true;
    }
    for (int i = 0; i < robots; i++) {
      String robot = "r" + i;
      assertTrue(
          floor.isArrived(robot) || floor.waitsForOneThatStays(robot),
          () -> robot + " of " + floor.reasons() + " on\n" + String.join("\n", picture(grid)));
    }
    return true;
  }

  /** The same floor in smaller cells, with a margin so that no lattice begins at its corner. */
  static OccupancyGrid finer(OccupancyGrid grid, int fine, double resolution, Random random) {
    int left = random.nextInt(fine);
    int top = random.nextInt(fine);
    int width = left + grid.width() * fine;
    int height = top + grid.height() * fine;
    BitSet occupied = new BitSet();
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        boolean isMargin = row < top || column < left;
        occupied.set(
            row * width + column,
            isMargin || !grid.isFree((column - left) / fine, (row - top) / fine));
      }
    }
    return new OccupancyGrid(width, height, resolution, Vec2.ZERO, occupied);
  }

  /** Corridors between blocks, some closed, some blocks hollow. */
  static OccupancyGrid aisles(Random random) {
    int width = 9 + random.nextInt(14);
    int height = 7 + random.nextInt(10);
    int spacing = 2 + random.nextInt(3);
    BitSet occupied = new BitSet();
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        boolean isAisle = row % spacing == 0 || column % (spacing + 1) == 0;
        boolean isClosed = isAisle && random.nextInt(12) == 0;
        boolean isHollow = !isAisle && random.nextInt(6) == 0;
        occupied.set(row * width + column, isClosed || (!isAisle && !isHollow));
      }
    }
    return new OccupancyGrid(width, height, DrivenFloor.CELL, Vec2.ZERO, occupied);
  }

  private static OccupancyGrid withAreas(OccupancyGrid grid, long seed) {
    return grid.withRules(DrawnAreas.of(grid, largestPart(grid), areaChance(seed)));
  }

  /** Seeds are told one after the other, and alike ones begin alike. */
  static Random areaChance(long seed) {
    return new Random(new SplittableRandom(seed).nextLong());
  }

  /** Those of the coarse floor on the finer one. */
  private static OccupancyGrid withAreas(
      OccupancyGrid coarse, OccupancyGrid grid, int fine, long seed) {
    Vec2 corner = place(grid, coarse, new Cell(0, coarse.height() - 1), fine);
    double side = fine * grid.resolution();
    return grid.withRules(
        DrawnAreas.scaled(
            DrawnAreas.of(coarse, largestPart(coarse), areaChance(seed)),
            side / coarse.resolution(),
            corner.minus(new Vec2(side / 2, side / 2))));
  }

  static List<Cell> largestPart(OccupancyGrid grid) {
    RoadGraph roads = new RoadGraph(grid);
    List<Cell> cells = new ArrayList<>();
    for (int v = 0; v < roads.vertexCount(); v++) {
      if (roads.isInLargestPart(v)) {
        cells.add(roads.cell(v));
      }
    }
    return cells;
  }

  static List<String> picture(OccupancyGrid grid) {
    List<String> rows = new ArrayList<>();
    for (int row = 0; row < grid.height(); row++) {
      char[] cells = new char[grid.width()];
      Arrays.fill(cells, '#');
      for (int column = 0; column < grid.width(); column++) {
        if (grid.isFree(column, row)) {
          cells[column] = '.';
        }
      }
      rows.add(new String(cells));
    }
    return rows;
  }
}
