package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** Whose way others cross without end has it closed to them after a while. */
class RightOfWayTest {
  private static final int WIDTH = 12;
  private static final int HEIGHT = 8;
  private static final int OTHERS = 8;
  private static final Duration PLANNING = Duration.ofMillis(10);
  private static final double LOAD = 0.3;
  private static final double LARGE = 0.55;

  /** Robots in each aisle. */
  private static final int IN_AISLE = 6;

  /** Two aisles, 0.8 m wide. */
  private static final OccupancyGrid AISLES =
      DrivenFloor.draw(
          "............",
          "............",
          "..########..",
          "..########..",
          "............",
          "............");

  /** Metres a second at which these robots drive on average, late as they are. */
  private static final double PACE = 0.1;

  @Test
  void aGroupGetsThroughAHallThatOthersCrossWithoutEnd() {
    OccupancyGrid hall =
        new OccupancyGrid(WIDTH, HEIGHT, DrivenFloor.CELL, Vec2.ZERO, new BitSet());
    DrivenFloor floor = new DrivenFloor(hall, 3, Duration.ZERO, PLANNING);
    Vec2 start = hall.centre(new Cell(2, HEIGHT / 2));
    Vec2 goal = hall.centre(new Cell(WIDTH - 3, HEIGHT / 2));
    putGroup(floor, "group", start);
    for (int i = 0; i < OTHERS; i++) {
      floor.put("r" + i, new Cell(1 + i * (WIDTH - 2) / OTHERS, i % 2 == 0 ? 0 : HEIGHT - 1));
    }
    Random random = new Random(3);
    cross(floor, random, floor.now.plusSeconds(10));

    floor.sendTo("group", goal);
    double drives = start.distanceTo(goal) / PACE;
    Instant limit =
        floor.now.plus(RightOfWay.AFTER.plus(RightOfWay.TURN)).plusSeconds((long) drives);
    cross(floor, random, limit);
    assertTrue(floor.isArrived("group"), () -> floor.reasons().toString());
  }

  /**
   * A group stays in one of two aisles, a small robot is at its goal in the other, and nowhere can
   * the two pass each other.
   */
  @Test
  void whoIsAtItsGoalInTheOnlyWayLetsALargeRobotByAndThenWaits() {
    double side = DrivenFloor.CELL;
    DrivenFloor floor = new DrivenFloor(AISLES, 3, Duration.ZERO, PLANNING);
    Vec2 inUpper = new Vec2(6 * side, 5 * side);
    putGroup(floor, "group", inUpper);
    floor.sendTo("group", inUpper);
    Cell inLower = new Cell(6, 5);
    floor.put("small", inLower);
    floor.send("small", inLower);
    Vec2 west = new Vec2(side, 5 * side);
    floor.putAt("large", west, LARGE);
    floor.drive(Duration.ofSeconds(5));

    floor.sendTo("large", new Vec2(11 * side, 5 * side));
    Instant limit = floor.now.plusSeconds(300);
    while (!floor.isArrived("large") && floor.now.isBefore(limit)) {
      floor.step();
    }
    assertTrue(floor.isArrived("large"), () -> floor.reasons().toString());

    floor.drive(Duration.ofMinutes(2));
    assertTrue(floor.isArrived("large"), () -> floor.reasons().toString());
    String reason = floor.reason("small");
    assertTrue(reason.startsWith("Waiting for large, which stays at its goal"), reason);

    floor.sendTo("large", west);
    floor.drive(Duration.ofMinutes(5));
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  @Test
  void whoCannotPassIsToldWhoStaysInAnAisleThatIsHardlyWiderThanItself() {
    double side = DrivenFloor.CELL;
    DrivenFloor floor = new DrivenFloor(AISLES, 3, Duration.ZERO, PLANNING);
    for (Vec2 load : List.of(new Vec2(6 * side, 5 * side), new Vec2(6 * side, side))) {
      String leader = "group%d".formatted(floor.bodies.size());
      putGroup(floor, leader, load);
      floor.sendTo(leader, load);
    }
    floor.putAt("large", new Vec2(side, 5 * side), LARGE);
    floor.sendTo("large", new Vec2(11 * side, 5 * side));
    floor.drive(Duration.ofSeconds(30));

    String reason = floor.reason("large");
    assertTrue(reason.matches("Waiting for group[01], which stays at its goal .*"), reason);
  }

  /** Small ones, too many to be planned whole, are at their goals all along both aisles. */
  @Test
  void whoIsTooLargeForTheLanesOfOthersIsToldWhoOfThemIsInItsWay() {
    double side = DrivenFloor.CELL;
    DrivenFloor floor = new DrivenFloor(AISLES, 3, Duration.ZERO, PLANNING);
    for (int i = 0; i < 2 * IN_AISLE; i++) {
      Cell place = new Cell(3 + i / 2, i % 2 == 0 ? 1 : 4);
      floor.put("r" + i, place);
      floor.send("r" + i, place);
    }
    floor.putAt("large", new Vec2(side, 5 * side), LARGE);
    floor.sendTo("large", new Vec2(11 * side, 5 * side));
    floor.drive(Duration.ofSeconds(30));

    String reason = floor.reason("large");
    assertTrue(reason.matches("Waiting for r\\d+, which blocks the path at .*"), reason);
  }

  private static void putGroup(DrivenFloor floor, String leader, Vec2 load) {
    FormationFootprint group =
        new FormationFootprint(
            new Shape(new Vec2(LOAD, 0), List.of(new Vec2(-LOAD, 0))),
            DrivenFloor.DIAMETER / 2,
            LOAD,
            LOAD);
    floor.putAt(
        leader, group.shape().leaderAt(new Pose(load.x(), load.y(), 0)), DrivenFloor.DIAMETER);
    floor.lead(leader, group);
  }

  /** Drives the others to and fro until the group is where it shall be, or the limit. */
  private static void cross(DrivenFloor floor, Random random, Instant limit) {
    double middle = HEIGHT * DrivenFloor.CELL / 2;
    boolean isSent = floor.body("group").goal != null;
    while (floor.now.isBefore(limit) && !(isSent && floor.isArrived("group"))) {
      for (int i = 0; i < OTHERS; i++) {
        DrivenBody body = floor.body("r" + i);
        if (floor.isArrived("r" + i)) {
          int row = body.pose.position().y() > middle ? HEIGHT - 1 : 0;
          floor.send("r" + i, new Cell(random.nextInt(WIDTH), row));
        }
      }
      floor.step();
    }
  }
}
