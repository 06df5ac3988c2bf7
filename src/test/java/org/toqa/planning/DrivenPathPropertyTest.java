package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.statistics.Statistics;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.RandomGrids.Query;

/**
 * A path that is planned on inflated obstacles, driven in segments, keeps the robot off the walls.
 */
class DrivenPathPropertyTest {
  private static final double ROBOT = 0.1275;
  private static final double FINE = 0.1;
  private static final double COARSE = 0.3;

  @Provide
  Arbitrary<Query> coarseRooms() {
    return RandomGrids.rooms(COARSE);
  }

  @Provide
  Arbitrary<Query> coarseStrewn() {
    return RandomGrids.strewn(5, 25, 0.3, COARSE);
  }

  @Provide
  Arbitrary<Query> fineStrewn() {
    return RandomGrids.strewn(15, 40, 0.04, FINE);
  }

  @Property
  void robotInRooms(
      @ForAll("coarseRooms") Query query, @ForAll @DoubleRange(min = -3, max = 3) double theta) {
    assertDrivenWayIsFree(query, Vec2.ZERO, theta);
  }

  @Property
  void robotAmongStrewnObstacles(
      @ForAll("coarseStrewn") Query query, @ForAll @DoubleRange(min = -3, max = 3) double theta) {
    assertDrivenWayIsFree(query, Vec2.ZERO, theta);
  }

  @Property
  void robotThatStandsAFewMillimetresOff(
      @ForAll("coarseRooms") Query query,
      @ForAll @DoubleRange(min = -0.01, max = 0.01) double dx,
      @ForAll @DoubleRange(min = -0.01, max = 0.01) double dy) {
    assertDrivenWayIsFree(query, new Vec2(dx, dy), 0);
  }

  @Property
  void robotLargerThanACell(
      @ForAll("fineStrewn") Query query, @ForAll @DoubleRange(min = -3, max = 3) double theta) {
    assertDrivenWayIsFree(query, Vec2.ZERO, theta);
  }

  private static void assertDrivenWayIsFree(Query query, Vec2 offCentre, double theta) {
    OccupancyGrid walls = query.grid();
    OccupancyGrid inflated = Inflation.inflate(walls, ROBOT);
    Cell goal = query.goal();
    PlanResult result = new HeadingAStar().plan(inflated, query.start(), goal);
    Statistics.label("a path was found")
        .collect(result instanceof Found)
        .coverage(coverage -> coverage.check(true).percentage(p -> p > 30));
    if (!(result instanceof Found(Path path))) {
      return;
    }
    Vec2 from = walls.centre(query.start()).plus(offCentre);
    Trajectory trajectory =
        new SegmentFitter(DriveSpeeds.DEFAULT, walls.resolution())
            .fit(new Pose(from.x(), from.y(), theta), path.waypoints(walls));
    if (!path.waypoints(walls).isEmpty()) {
      assertEquals(0, trajectory.end().position().distanceTo(walls.centre(goal)), 1e-3);
    }
    if (path.waypoints(walls).size() > 1) { // the first leg points to its waypoint from off centre
      double arrival = path.steps().getLast().heading().angle();
      assertEquals(0, trajectory.end().relative(new Pose(0, 0, arrival)).theta(), 1e-3);
    }
    Disc robot = new Disc(ROBOT);
    int samples = (int) Math.ceil(trajectory.duration() / 0.02); // 5 mm apart
    for (int i = 0; i <= samples; i++) {
      Vec2 centre = trajectory.poseAt(i * 0.02).position();
      assertTrue(robot.isFreeAt(walls, centre), () -> "The robot hits a wall at " + centre);
    }
  }
}
