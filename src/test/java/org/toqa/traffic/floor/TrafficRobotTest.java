package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/** What is a robot's own. */
class TrafficRobotTest {
  private static final double RADIUS = 0.1275;

  /** On its last path it faced another way, and nobody was with it. */
  @Test
  void aGroupHasWhereItsRobotsAre() {
    OccupancyGrid floor = DrivenFloor.draw("......", "......", "......", "......", "......");
    Pose before = new Pose(1.2, 1, 0);
    Pose now = new Pose(1.2, 1, Math.PI / 2);
    TrafficRobot leader = new TrafficRobot("r1", 1, floor, before, RADIUS, Instant.EPOCH);
    leader.continueOn(ReservedPath.independent(before, List.of()));
    leader.stop();
    leader.setPose(now, RADIUS);
    FormationFootprint group =
        new FormationFootprint(Shape.around(2, 0.5, 0.2, RADIUS), RADIUS, 0.5, 0.2);
    leader.setFormation(group);

    for (PlacedDisc disc : group.discs(now)) {
      Vec2 middle = disc.centre();
      assertTrue(
          leader.allocated().stream().anyMatch(area -> area.gapTo(middle) < -RADIUS / 2),
          () -> middle + " is nobody's");
    }
  }
}
