package org.toqa.agent.drive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

class ReferenceTrajectoryProperties {

  private static final double TICK = 0.02;
  private static final int MANY_TICKS = 20_000;
  private static final MotionLimits LIMITS = new MotionLimits(0.5, 3.5, 0.5, 3);
  private static final Pose START = new Pose(1, 2, 0.5);

  @Property(tries = 200)
  void referenceEndsExactlyAtTheEndOfWhatIsReleased(
      @ForAll("segments") @Size(min = 1, max = 8) List<Segment> segments,
      @ForAll @IntRange(max = 8) int released) {
    int count = Math.min(released, segments.size());
    ReferenceTrajectory reference =
        new ReferenceTrajectory(START, segments, count, PaceLimits.forSingleRobot(LIMITS));
    runToAStand(reference);

    Pose end = new Trajectory(START, segments).poseAfter(count);
    assertEquals(count, reference.completedCount());
    assertEquals(0, end.distanceTo(reference.pose()), 1e-9);
  }

  @Property(tries = 200)
  void referenceMovesNoFasterThanItsSegmentsAndStopsNoHarderThanItMay(
      @ForAll("segments") @Size(min = 1, max = 8) List<Segment> segments) {
    ReferenceTrajectory reference =
        new ReferenceTrajectory(
            START, segments, segments.size(), PaceLimits.forSingleRobot(LIMITS));
    double fastest = segments.stream().mapToDouble(Segment::speed).max().orElseThrow();
    for (int i = 0; i < MANY_TICKS && reference.completedCount() < reference.size(); i++) {
      Pose before = reference.pose();
      int segment = reference.completedCount();
      Twist twist = reference.twist();
      reference.advance(TICK, i % 300 < 200 ? 1 : 0);

      assertTrue(before.distanceTo(reference.pose()) <= fastest * TICK + 1e-9);
      if (reference.completedCount() == segment) {
        double change =
            Math.hypot(reference.twist().vx() - twist.vx(), reference.twist().vy() - twist.vy());
        assertTrue(change <= LIMITS.acceleration() * TICK + 1e-9, "changes by " + change);
      }
    }
  }

  @Property(tries = 100)
  void trajectoryReleasedPieceByPieceEndsWhereTheWholeDoes(
      @ForAll("segments") @Size(min = 2, max = 6) List<Segment> segments) {
    ReferenceTrajectory reference =
        new ReferenceTrajectory(START, segments, 0, PaceLimits.forSingleRobot(LIMITS));
    for (int count = 1; count <= segments.size(); count++) {
      reference.release(count);
      runToAStand(reference);
    }

    assertEquals(0, new Trajectory(START, segments).end().distanceTo(reference.pose()), 1e-9);
  }

  @Property(tries = 100)
  void heldReferenceStandsAndGoesOn(
      @ForAll("segments") @Size(min = 1, max = 4) List<Segment> segments,
      @ForAll @IntRange(min = 1, max = 400) int ticks) {
    ReferenceTrajectory reference =
        new ReferenceTrajectory(
            START, segments, segments.size(), PaceLimits.forSingleRobot(LIMITS));
    for (int i = 0; i < ticks; i++) {
      reference.advance(TICK, 1);
    }
    for (int i = 0; i < 500; i++) {
      reference.advance(TICK, 0);
    }
    Pose held = reference.pose();
    assertTrue(reference.isStanding());
    reference.advance(TICK, 0);
    assertEquals(held, reference.pose());

    runToAStand(reference);
    assertEquals(0, new Trajectory(START, segments).end().distanceTo(reference.pose()), 1e-9);
  }

  @Provide
  Arbitrary<List<Segment>> segments() {
    Arbitrary<Segment> any =
        Combinators.combine(
                Arbitraries.doubles().between(-0.5, 0.5),
                Arbitraries.doubles().between(-3.5, 3.5),
                Arbitraries.doubles().between(0.01, 10))
            .as((v, w, t) -> new Segment(v, w, t));
    Arbitrary<Segment> shift =
        Combinators.combine(
                Arbitraries.doubles().between(-0.5, 0.5), Arbitraries.doubles().between(0.01, 10))
            .as((u, t) -> Segment.shift(u, t));
    return Arbitraries.frequencyOf(Tuple.of(3, any), Tuple.of(1, shift)).list();
  }

  private static void runToAStand(ReferenceTrajectory reference) {
    reference.advance(TICK, 1);
    for (int i = 0; i < MANY_TICKS && !reference.isStanding(); i++) {
      reference.advance(TICK, 1);
    }
    assertTrue(reference.isStanding(), "it stops");
  }
}
