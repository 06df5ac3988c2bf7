package org.toqa.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Size;
import org.toqa.formation.TrajectoryRules.Breach;
import org.toqa.formation.TrajectoryRules.Fault;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;

class TrajectoryRulesPropertyTest {

  private static final double MOST_SPEED = 0.3;
  private static final Pose START = new Pose(1, 2, 0.5);
  private static final Shape TRIANGLE = Shape.around(3, 0.6, 0.4, 0.1275);

  private final TrajectoryRules rules = new TrajectoryRules(TRIANGLE, MOST_SPEED);

  @Provide
  Arbitrary<List<Segment>> segments() {
    Arbitrary<Double> seconds = Arbitraries.doubles().between(0.1, 3);
    Arbitrary<Segment> ahead =
        Combinators.combine(
                Arbitraries.doubles().between(0.05, 0.5),
                Arbitraries.doubles().between(-1.5, 1.5),
                seconds)
            .as((v, w, t) -> new Segment(v, w, t));
    Arbitrary<Segment> aside =
        Combinators.combine(Arbitraries.doubles().between(-0.5, 0.5), seconds)
            .as((u, t) -> Segment.shift(u, t));
    return Arbitraries.frequencyOf(Tuple.of(3, ahead), Tuple.of(1, aside)).list();
  }

  @Property(tries = 200)
  void slowedWayIsTheSameWayAndNoRobotIsTooFastOnIt(
      @ForAll("segments") @Size(min = 1, max = 5) List<Segment> segments) {
    Trajectory trajectory = new Trajectory(START, segments);
    Trajectory slowed = rules.slowed(trajectory);

    assertEquals(0, trajectory.end().distanceTo(slowed.end()), 1e-9);
    double step = 0.001;
    double elapsed = 0;
    for (Segment segment : slowed.segments()) {
      Pose before = slowed.poseAt(elapsed);
      Pose after = before.advanced(segment.twist(), step);
      for (int i = 0; i < 2; i++) {
        double driven =
            TRIANGLE.followersAt(before).get(i).distanceTo(TRIANGLE.followersAt(after).get(i));
        assertTrue(driven / step <= MOST_SPEED + 1e-6, "a follower drives " + driven / step);
      }
      assertTrue(segment.speed() <= MOST_SPEED + 1e-12);
      elapsed += segment.t();
    }
  }

  @Property(tries = 200)
  void cornersOfTheLengthThatIsAskedForAreNotTooTight(
      @ForAll @DoubleRange(min = 0.2, max = 1.57) double angle) {
    double length = rules.cornerLength(angle);
    SegmentFitter fitter = new SegmentFitter(DriveSpeeds.DEFAULT, length);
    Vec2 corner = new Vec2(2 * length, 0);
    Trajectory trajectory =
        fitter.fit(
            new Pose(0, 0, 0),
            List.of(
                new Waypoint(corner, false),
                new Waypoint(corner.plus(new Vec2(2 * length, 0).rotated(angle)), false)));

    assertEquals(Optional.empty(), rules.firstBreach(trajectory));
  }

  @Example
  void outerRobotOfALineAbreastSetsTheSpeed() {
    Shape abreast = new Shape(new Vec2(0, 0.5), List.of(new Vec2(0, -0.5)));
    Trajectory left = new Trajectory(START, List.of(new Segment(0.3, 0.3, 2)));

    // radius 1 m, the follower 1 m outside: v (1 + 1)/1 = 0.3 m/s, so v = 0.15 m/s
    Segment slowed = new TrajectoryRules(abreast, 0.3).slowed(left).segments().getFirst();
    assertEquals(0.15, slowed.v(), 1e-12);
    assertEquals(0.15, slowed.w(), 1e-12);
    assertEquals(4, slowed.t(), 1e-12);
  }

  @Example
  void waysThatNoShapeCanBeLedAlongAreNamed() {
    Segment straight = new Segment(0.25, 0, 1);
    double tight = 0.25 / (TRIANGLE.smallestRadius() - 0.01);

    assertEquals(
        Optional.of(new Breach(Fault.TURN_ON_THE_SPOT, 1)),
        rules.firstBreach(new Trajectory(START, List.of(straight, new Segment(0, 1, 1)))));
    assertEquals(
        Optional.of(new Breach(Fault.TOO_TIGHT, 0)),
        rules.firstBreach(new Trajectory(START, List.of(new Segment(0.25, -tight, 1), straight))));
    assertEquals(
        Optional.of(new Breach(Fault.BACKWARDS, 0)),
        rules.firstBreach(new Trajectory(START, List.of(new Segment(-0.1, 0, 1)))));
    Trajectory shift = new Trajectory(START, List.of(straight, Segment.shift(0.1, 1)));
    assertEquals(Optional.empty(), rules.firstBreach(shift));
    assertEquals(
        Optional.of(new Breach(Fault.SIDEWAYS, 1)),
        new TrajectoryRules(TRIANGLE.withMobility(GroupMobility.FORWARD), MOST_SPEED)
            .firstBreach(shift));
  }
}
