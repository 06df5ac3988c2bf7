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

  /** Metres a second at which these robots drive on average, late as they are. */
  private static final double PACE = 0.1;

  @Test
  void aGroupGetsThroughAHallThatOthersCrossWithoutEnd() {
    OccupancyGrid hall =
        new OccupancyGrid(WIDTH, HEIGHT, DrivenFloor.CELL, Vec2.ZERO, new BitSet());
    DrivenFloor floor = new DrivenFloor(hall, 3, Duration.ZERO, PLANNING);
    Vec2 start = hall.centre(new Cell(2, HEIGHT / 2));
    Vec2 goal = hall.centre(new Cell(WIDTH - 3, HEIGHT / 2));
    FormationFootprint group =
        new FormationFootprint(
            new Shape(new Vec2(LOAD, 0), List.of(new Vec2(-LOAD, 0))),
            DrivenFloor.DIAMETER / 2,
            LOAD,
            LOAD);
    floor.putAt(
        "group", group.shape().leaderAt(new Pose(start.x(), start.y(), 0)), DrivenFloor.DIAMETER);
    floor.lead("group", group);
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
