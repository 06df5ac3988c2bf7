package org.toqa.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;

class SegmentFitterPropertyTest {
  private final SegmentFitter fitter = new SegmentFitter(DriveSpeeds.DEFAULT, 0.3);

  @Provide
  Arbitrary<List<Waypoint>> paths() {
    Arbitrary<Double> metres = Arbitraries.doubles().between(-20, 20).ofScale(3);
    return Combinators.combine(metres, metres, Arbitraries.of(true, false, false))
        .as((x, y, spot) -> new Waypoint(new Vec2(x, y), spot))
        .list()
        .ofMinSize(1)
        .ofMaxSize(40);
  }

  @Property
  void segmentsEndAtTheEndOfTheWay(
      @ForAll("paths") List<Waypoint> path,
      @ForAll @DoubleRange(min = -3, max = 3) double theta,
      @ForAll @DoubleRange(min = -3, max = 3) double heading) {
    Trajectory trajectory = fitter.fit(new Pose(0.1, -0.2, theta), path, heading);
    Vec2 goal = path.getLast().position();
    assertEquals(0, trajectory.end().position().distanceTo(goal), 1e-3);
    assertEquals(0, trajectory.end().relative(new Pose(0, 0, heading)).theta(), 1e-3);
  }

  @Property
  void noSegmentIsFasterThanItsLimits(@ForAll("paths") List<Waypoint> path) {
    for (Segment segment : fitter.fit(new Pose(0, 0, 0), path).segments()) {
      assertTrue(segment.t() > 0 && Double.isFinite(segment.t()));
      assertTrue(segment.v() >= 0 && segment.v() <= 0.25 + 1e-12);
      assertTrue(Math.abs(segment.w()) <= 1.5 + 1e-12);
    }
  }

  @Property
  void robotStaysNearTheLegs(@ForAll("paths") List<Waypoint> path) {
    Trajectory trajectory = fitter.fit(new Pose(0, 0, 0), path);
    double duration = trajectory.duration();
    for (int i = 0; i <= 500; i++) {
      Vec2 robot = trajectory.poseAt(duration * i / 500).position();
      // an arc begins at most L/2 before its corner, so it is never farther from a leg than that
      assertTrue(distanceToPath(robot, path) <= 0.15 + 1e-3, () -> robot + " is off the path");
    }
  }

  private static double distanceToPath(Vec2 p, List<Waypoint> path) {
    Vec2 from = Vec2.ZERO;
    double nearest = Double.POSITIVE_INFINITY;
    for (Waypoint waypoint : path) {
      Vec2 leg = waypoint.position().minus(from);
      Vec2 ap = p.minus(from);
      double squared = leg.x() * leg.x() + leg.y() * leg.y();
      double t = squared == 0 ? 0 : (ap.x() * leg.x() + ap.y() * leg.y()) / squared;
      nearest = Math.min(nearest, p.distanceTo(from.plus(leg.times(Math.clamp(t, 0, 1)))));
      from = waypoint.position();
    }
    return nearest;
  }
}
