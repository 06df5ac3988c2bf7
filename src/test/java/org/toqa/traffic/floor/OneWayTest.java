package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Cell;
import org.toqa.grid.Direction;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;
import org.toqa.grid.SpeedLimit;

/** Areas that are driven one way or slowly; {@link AreaJudge} looks at where robots really are. */
class OneWayTest {
  private static final double CELL = DrivenFloor.CELL;
  private static final double LOAD = 0.3;

  /** Two aisles of opposite direction, joined at both ends, with bays outside. */
  private static final OccupancyGrid ROUNDABOUT =
      DrivenFloor.draw(
              "#.#.#.#.#.#", //
              "...........",
              ".#########.",
              "...........",
              "#.#.#.#.#.#")
          .withRules(
              new MoveRules(
                  List.of(
                      new OneWay(cells(1, 3, 9, 3), Direction.EAST),
                      new OneWay(cells(1, 1, 9, 1), Direction.WEST)),
                  List.of(),
                  List.of(new SpeedLimit(cells(4, 3, 6, 3), 0.1))));

  @Test
  void robotsGoRoundForLongAndNobodyIsStuck() {
    DrivenFloor floor = new DrivenFloor(ROUNDABOUT, 1);
    Random random = new Random(1);
    int[] reached = new int[6];
    double[] since = new double[reached.length];
    for (int i = 0; i < reached.length; i++) {
      floor.put("r" + i, bay(i));
    }
    for (int step = 0; step < 12_000; step++) { // 20 minutes
      for (int i = 0; i < reached.length; i++) {
        if (floor.isArrived("r" + i)) {
          reached[i]++;
          since[i] = step;
          floor.send("r" + i, freeBay(floor, random));
        }
        assertTrue(step - since[i] < 3000, () -> "stuck: " + floor.reasons());
      }
      floor.step();
    }
    assertTrue(Arrays.stream(reached).allMatch(count -> count > 5), Arrays.toString(reached));
  }

  private static Cell bay(int number) {
    return new Cell(1 + 2 * (number % 5), number < 5 ? 0 : 4);
  }

  private static Cell freeBay(DrivenFloor floor, Random random) {
    while (true) {
      Cell bay = bay(random.nextInt(10));
      Vec2 middle = floor.grid.centre(bay);
      if (floor.bodies.values().stream().noneMatch(body -> middle.equals(body.goal))) {
        return bay;
      }
    }
  }

  @Test
  void whoeverCouldOnlyGoAgainstADirectionIsToldSo() {
    OccupancyGrid aisle =
        DrivenFloor.draw("........")
            .withRules(
                new MoveRules(
                    List.of(new OneWay(cells(3, 0, 5, 0), Direction.EAST)), List.of(), List.of()));
    DrivenFloor floor = new DrivenFloor(aisle, 1);
    floor.put("a", new Cell(6, 0));
    floor.send("a", new Cell(0, 0));
    floor.drive(Duration.ofSeconds(20));
    assertEquals(
        "Waiting: the only path to (0.20, 0.20) leads against the one-way direction at"
            + " (2.20, 0.20); change the map, or move the robot by hand",
        floor.reason("a"));
    assertTrue(floor.isAt("a", new Cell(6, 0)));

    floor.send("a", null);
    floor.put("b", new Cell(0, 0));
    floor.send("b", new Cell(4, 0));
    floor.drive(Duration.ofMinutes(1));
    assertTrue(floor.isArrived("b"), () -> floor.reasons().toString());
  }

  @Test
  void aPlaceIsComeToInItsDirectionOnly() {
    Cell place = new Cell(4, 2);
    OccupancyGrid hall =
        DrivenFloor.draw(".........", ".........", ".........", ".........", ".........")
            .withRules(
                new MoveRules(
                    List.of(), List.of(new OneWay(cells(4, 2, 4, 2), Direction.NORTH)), List.of()));
    for (Cell start : List.of(new Cell(0, 2), new Cell(8, 2), new Cell(4, 0), new Cell(4, 4))) {
      DrivenFloor floor = new DrivenFloor(hall, 1);
      floor.put("a", start);
      floor.put("b", new Cell(0, 0));
      floor.send("a", place);
      floor.send("b", new Cell(8, 4));
      floor.drive(Duration.ofMinutes(2));
      assertTrue(floor.areAllArrived(), () -> floor.reasons() + " from " + start);
    }
  }

  @Test
  void aGroupGoesRoundRatherThanAgainstADirection() {
    OccupancyGrid hall =
        DrivenFloor.draw(
                "................",
                "................",
                "................",
                "................",
                "....########....",
                "................",
                "................",
                "................",
                "................")
            .withRules(
                new MoveRules(
                    List.of(new OneWay(cells(4, 0, 11, 3), Direction.WEST)),
                    List.of(),
                    List.of(new SpeedLimit(cells(6, 5, 9, 8), 0.08))));
    DrivenFloor floor = new DrivenFloor(hall, 1);
    FormationFootprint group =
        new FormationFootprint(
            new Shape(new Vec2(LOAD, 0), List.of(new Vec2(-LOAD, 0))),
            DrivenFloor.DIAMETER / 2,
            LOAD,
            LOAD);
    Vec2 start = hall.centre(new Cell(2, 7));
    floor.putAt(
        "group", group.shape().leaderAt(new Pose(start.x(), start.y(), 0)), DrivenFloor.DIAMETER);
    floor.lead("group", group);
    floor.sendTo("group", hall.centre(new Cell(13, 6)));
    double north = 0;
    for (int step = 0; step < 3000 && !floor.isArrived("group"); step++) {
      floor.step();
      north = Math.max(north, floor.body("group").carries().y());
    }
    assertTrue(floor.isArrived("group"), () -> floor.reasons().toString());
    assertTrue(north > 5 * CELL, "it went round by the north, not only to " + north);
  }

  @Test
  void limitsBeginBeforeAnAreaAndSlowNobodyElsewhere() {
    OccupancyGrid aisle =
        DrivenFloor.draw("..........")
            .withRules(
                new MoveRules(
                    List.of(), List.of(), List.of(new SpeedLimit(cells(4, 0, 5, 0), 0.1))));
    DrivenFloor floor = new DrivenFloor(aisle, 1);
    floor.put("a", new Cell(0, 0));
    floor.send("a", new Cell(9, 0));
    double slow = 0;
    double fast = 0;
    while (!floor.isArrived("a")) {
      floor.step();
      var trajectory = floor.body("a").trajectory;
      if (trajectory != null && floor.body("a").completed < trajectory.segments().size()) {
        double v = trajectory.segments().get(floor.body("a").completed).v();
        double x = floor.body("a").pose.x();
        boolean isIn = x > 4 * CELL - MoveRules.SLOWING + 0.02 && x < 6 * CELL;
        slow = isIn ? Math.max(slow, v) : slow;
        fast = isIn ? fast : Math.max(fast, v);
      }
    }
    assertEquals(0.1, slow, 1e-9);
    assertEquals(0.25, fast, 1e-9);
  }

  @Test
  void aFloorWithoutAreasHasNoRules() {
    assertFalse(DrivenFloor.draw("..").rules().isDirected());
    assertTrue(DrivenFloor.draw("..").rules().isNone());
  }

  /** From one corner to the other, the cells included; here rows count from the south. */
  private static Area cells(int column, int row, int lastColumn, int lastRow) {
    return new Area(
        new Vec2(column, row).times(CELL),
        (lastColumn - column + 1) * CELL,
        (lastRow - row + 1) * CELL);
  }
}
