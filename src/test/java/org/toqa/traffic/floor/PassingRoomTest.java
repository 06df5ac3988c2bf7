package org.toqa.traffic.floor;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.motion.PassingRoom;

/** Room beside the path of a robot that sees something there. */
class PassingRoomTest {
  static final String[] HALL = {
    "##################",
    "#................#",
    "#................#",
    "#................#",
    "#................#",
    "#................#",
    "##################",
  };

  private static final String[] CORRIDOR = {
    "##################", "#................#", "##################",
  };

  private static DrivenFloor driving(String[] rows) {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw(rows), 1);
    floor.put("a", new Cell(1, rows.length / 2));
    floor.send("a", new Cell(16, rows.length / 2));
    while (floor.body("a").completed < 2) {
      floor.step();
    }
    return floor;
  }

  private static Vec2 ahead(DrivenFloor floor, double metres, double left) {
    return floor.body("a").pose.compose(new Pose(metres, left, 0)).position();
  }

  @Test
  void inAHallARobotIsLentRoomOnTheSideWhereLessIsNeeded() {
    DrivenFloor floor = driving(HALL);

    assertTrue(floor.traffic.lendRoom("a", List.of(ahead(floor, 0.9, 0.03)), floor.now));
    floor.step();

    PassingRoom room = requireNonNull(floor.body("a").room);
    assertEquals(0, room.left());
    // 0.1275 + 0.09 - 0.03 = 0.1875, and 0.1 to spare
    assertEquals(0.2875, room.right(), 1e-9);
    floor.drive(Duration.ofMinutes(2));
    assertTrue(floor.isArrived("a"));
    assertFalse(floor.traffic.hasRoom("a"));
  }

  @Test
  void inACorridorThereIsNone() {
    DrivenFloor floor = driving(CORRIDOR);

    assertFalse(floor.traffic.lendRoom("a", List.of(ahead(floor, 0.9, 0)), floor.now));
    floor.step();
    assertNull(floor.body("a").room);
  }

  @Test
  void whoStandsBesideThePathKeepsItsPlaceAndTheOtherSideIsLent() {
    DrivenFloor floor = driving(HALL);
    Cell beside = floor.grid.cellAt(ahead(floor, 0.9, 0.4));
    floor.put("b", beside);

    assertTrue(floor.traffic.lendRoom("a", List.of(ahead(floor, 0.9, -0.02)), floor.now));
    floor.step();

    assertEquals(0, requireNonNull(floor.body("a").room).left());
    floor.drive(Duration.ofMinutes(2));
    assertTrue(floor.isArrived("a"), floor.reasons().toString());
  }

  @Test
  void twoRobotsAreNotLentTheSamePlace() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw(HALL), 1);
    floor.put("a", new Cell(1, 2));
    floor.put("b", new Cell(1, 4));
    floor.send("a", new Cell(16, 2));
    floor.send("b", new Cell(16, 4));
    while (floor.body("a").completed < 2 || floor.body("b").completed < 2) {
      floor.step();
    }
    // from a, what it sees on its left needs the right; from b, likewise what lies between them
    Vec2 leftOfA = floor.body("a").pose.compose(new Pose(0.9, 0.1, 0)).position();
    Vec2 rightOfB = floor.body("b").pose.compose(new Pose(0.9, -0.1, 0)).position();
    boolean isLentA = floor.traffic.lendRoom("a", List.of(leftOfA), floor.now);
    boolean isLentB = floor.traffic.lendRoom("b", List.of(rightOfB), floor.now);

    assertTrue(isLentA || isLentB);
    floor.drive(Duration.ofMinutes(3));
    assertTrue(floor.areAllArrived(), floor.reasons().toString());
  }

  @Test
  void aLostRobotKeepsItsRoomUntilItIsFoundAndOthersWait() {
    DrivenFloor floor = driving(HALL);
    assertTrue(floor.traffic.lendRoom("a", List.of(ahead(floor, 0.9, 0)), floor.now));
    floor.step();
    PassingRoom room = requireNonNull(floor.body("a").room);
    floor.lose("a");
    floor.body("a").isStuck = true;
    double middle = (room.left() - room.right()) / 2;
    Cell wanted = floor.grid.cellAt(ahead(floor, 0.9, Math.signum(middle) * 0.3));
    floor.put("b", new Cell(14, 1));
    floor.send("b", wanted);

    floor.driveWhileAnyMoves(Duration.ofSeconds(30));
    assertFalse(floor.isArrived("b"), "it is at " + floor.body("b").pose);

    floor.body("a").isStuck = false;
    floor.find("a");
    floor.drive(Duration.ofMinutes(3));
    assertTrue(floor.areAllArrived(), floor.reasons().toString());
  }

  @Test
  void roomIsAdoptedWithTheTrajectoryAfterARestart() {
    DrivenFloor floor = driving(HALL);
    assertTrue(floor.traffic.lendRoom("a", List.of(ahead(floor, 0.9, 0)), floor.now));
    floor.step();
    DrivenBody body = floor.body("a");
    DrivenFloor restarted = new DrivenFloor(floor.grid, 2);

    restarted.traffic.adoptTrajectory(
        "a",
        body.place(),
        body.diameter,
        requireNonNull(body.trajectory),
        body.completed,
        body.released,
        restarted.now);
    restarted.traffic.adoptRoom("a", requireNonNull(body.room));

    assertEquals(floor.traffic.allocatedCells("a"), restarted.traffic.allocatedCells("a"));
    restarted.traffic.reportStanding("a", body.place(), body.diameter, restarted.now);
    assertFalse(restarted.traffic.hasRoom("a"));
  }
}
