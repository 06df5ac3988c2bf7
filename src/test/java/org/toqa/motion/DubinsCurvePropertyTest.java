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

class DubinsCurvePropertyTest {
  private static final DriveSpeeds SPEEDS = DriveSpeeds.DEFAULT;

  @Provide
  Arbitrary<Pose> poses() {
    Arbitrary<Double> metres = Arbitraries.doubles().between(-5, 5).ofScale(3);
    Arbitrary<Double> radians = Arbitraries.doubles().between(-3.14, 3.14).ofScale(3);
    return Combinators.combine(metres, metres, radians).as(Pose::new);
  }

  @Property
  void curvesEndThere(
      @ForAll("poses") Pose from,
      @ForAll("poses") Pose to,
      @ForAll @DoubleRange(min = 0.1, max = 2) double radius) {
    List<DubinsCurve> curves = DubinsCurve.between(from, to, radius);
    assertTrue(curves.size() >= 2, curves::toString);
    for (DubinsCurve curve : curves) {
      Trajectory trajectory = new Trajectory(from, curve.segments(SPEEDS));
      Pose beside = trajectory.end().relative(to);
      assertEquals(0, beside.position().norm(), 1e-6);
      assertEquals(0, beside.theta(), 1e-6);
      assertEquals(curve.length(), trajectory.length(), 1e-6);
    }
  }

  @Property
  void noArcIsTighterAndNoneGoesBackwards(
      @ForAll("poses") Pose from,
      @ForAll("poses") Pose to,
      @ForAll @DoubleRange(min = 0.1, max = 2) double radius) {
    for (DubinsCurve curve : DubinsCurve.between(from, to, radius)) {
      for (Segment segment : curve.segments(SPEEDS)) {
        assertTrue(segment.v() > 0 && segment.v() <= SPEEDS.forward() + 1e-12);
        assertTrue(segment.w() == 0 || segment.v() / Math.abs(segment.w()) >= radius - 1e-9);
      }
    }
  }

  @Property
  void straightAheadIsOneOfThem(
      @ForAll("poses") Pose from, @ForAll @DoubleRange(min = 0.01, max = 5) double ahead) {
    Pose to = from.compose(new Pose(ahead, 0, 0));
    assertTrue(
        DubinsCurve.between(from, to, 0.3).stream()
            .anyMatch(curve -> Math.abs(curve.length() - ahead) < 1e-6));
  }
}
