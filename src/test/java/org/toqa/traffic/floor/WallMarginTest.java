package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.mapf.LacamJointPlanner;

/** What is kept from walls is what is configured. */
class WallMarginTest {
  private static final double DIAMETER = 0.255;
  private static final double RESOLUTION = 0.1;
  private static final int WIDTH = 60;
  private static final int HEIGHT = 40;

  /** From the upper edge down, so many of the rows are open. */
  private static OccupancyGrid hall(int openRows) {
    BitSet occupied = new BitSet();
    IntStream.range(openRows, HEIGHT)
        .forEach(row -> occupied.set(row * WIDTH + 28, row * WIDTH + 32));
    return new OccupancyGrid(WIDTH, HEIGHT, RESOLUTION, Vec2.ZERO, occupied);
  }

  @Test
  void robotKeepsItsMarginWhereThereIsRoom() {
    double kept = 0.3;
    double usual = gapOnTheWay(Margins.USUAL);
    assertTrue(usual > 0.05 && usual < kept, () -> "kept " + usual);
    assertTrue(gapOnTheWay(new Margins(kept, 0.02)) > kept - 1e-6);
  }

  /** Between a robot and the wall that it goes round, where it is nearest. */
  private static double gapOnTheWay(Margins margins) {
    OccupancyGrid grid = hall(25);
    FloorTraffic traffic = new FloorTraffic(grid, margins, new LacamJointPlanner(), Deadline::none);
    traffic.reportStanding("r", new Pose(1.05, 1.05, 0), DIAMETER, Instant.EPOCH);
    traffic.setMovable("r", true);
    traffic.setGoal("r", new Vec2(4.95, 1.05), Instant.EPOCH);
    List<DriveCommand> decided = traffic.decide(Instant.EPOCH);
    Trajectory trajectory = ((DriveCommand.Begin) decided.getFirst()).trajectory();
    double nearest = Double.POSITIVE_INFINITY;
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      for (double share = 0; share <= 1; share += 0.01) {
        Vec2 at = pose.advanced(segment.twist(), share * segment.t()).position();
        nearest = Math.min(nearest, gap(grid, at));
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return nearest;
  }

  private static double gap(OccupancyGrid grid, Vec2 at) {
    return grid.occupied().stream()
            .mapToDouble(cell -> Disc.distanceToCell(grid, at, grid.cell(cell)))
            .min()
            .orElseThrow()
        - DIAMETER / 2;
  }

  @Test
  void formationComesThroughAPassageOnlyWithItsMargin() {
    OccupancyGrid grid = hall(14);
    Shape shape = Shape.around(2, 0.4, 0.4, DIAMETER / 2);
    FormationFootprint formation = new FormationFootprint(shape, DIAMETER / 2, 0.4, 0.4);
    Pose leader = FormationLattice.of(grid).nearest(new Pose(1.2, 2, 0));
    Vec2 goal = new Vec2(4.5, 2);
    FormationPaths usual = new FormationPaths(grid, Margins.USUAL, goal);
    FormationPaths wide = new FormationPaths(grid, new Margins(0.05, 0.6), goal);

    double door = 14 * RESOLUTION;
    assertTrue(
        usual.hasPath(formation, leader, false), () -> "needs " + usual.passageWidth(formation));
    assertTrue(usual.passageWidth(formation) < door && door < wide.passageWidth(formation));
    assertFalse(wide.hasPath(formation, leader, false));
  }
}
