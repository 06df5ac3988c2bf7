package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;

class SimulatedFloorTest {
  private static final double RADIUS = 0.2;
  private static final double FAR = 8;
  private static final Pose EASTWARD = new Pose(1, 1.5, 0);

  private final SimulatedFloor floor =
      SimulatedFloor.of(
          new FloorMap(
              "hall",
              OccupancyGrid.parse("......", ".....#", "......"),
              List.of(),
              List.of(),
              List.of()));
  private final Surroundings seenByR1 = floor.surroundings("r1", RADIUS);

  @Test
  void theNearestOfWallsObstaclesAndOtherRobotsIsSeen() {
    Surroundings ofR2 = floor.surroundings("r2", RADIUS);
    seenByR1.setTruePose(EASTWARD);
    assertEquals(4, seenByR1.distance(EASTWARD, FAR), 1e-12);

    ofR2.setTruePose(new Pose(4, 1.5, 0));
    assertEquals(3 - RADIUS, seenByR1.distance(EASTWARD, FAR), 1e-12);
    assertEquals(3 - RADIUS, ofR2.distance(new Pose(4, 1.5, Math.PI), FAR), 1e-12);

    // 0.3 m beside the ray, 0.5 m of radius: the disc begins 0.4 m before its middle
    floor.putObstacle("box", new Vec2(3, 1.8), 0.5);
    assertEquals(1.6, seenByR1.distance(EASTWARD, FAR), 1e-12);
    floor.putObstacle("box", new Vec2(3, 2.1), 0.5);
    assertEquals(3 - RADIUS, seenByR1.distance(EASTWARD, FAR), 1e-12);
    floor.putObstacle("box", new Vec2(0.4, 1.5), 0.5);
    assertEquals(3 - RADIUS, seenByR1.distance(EASTWARD, FAR), 1e-12);

    floor.putObstacle("box", new Vec2(3, 1.5), 0.5);
    floor.removeObstacle("box");
    assertEquals(3 - RADIUS, seenByR1.distance(EASTWARD, FAR), 1e-12);
    assertEquals(2, seenByR1.distance(EASTWARD, 2), 1e-12);
  }

  @Test
  void marksLieInRowsOnAFloorWithAMap() {
    assertTrue(seenByR1.isMarked(new Vec2(0.15, 1.05)));
    assertTrue(seenByR1.isMarked(new Vec2(0.48, 1.08)));
    assertFalse(seenByR1.isMarked(new Vec2(0.30, 1.05)));
    assertFalse(
        SimulatedFloor.boundless().surroundings("r1", RADIUS).isMarked(new Vec2(0.15, 1.05)));
  }
}
