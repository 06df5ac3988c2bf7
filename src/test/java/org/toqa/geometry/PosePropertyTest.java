package org.toqa.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;

class PosePropertyTest {

  @Provide
  Arbitrary<Pose> poses() {
    Arbitrary<Double> metres = Arbitraries.doubles().between(-100, 100);
    return Combinators.combine(metres, metres, Arbitraries.doubles().between(-10, 10))
        .as(Pose::new);
  }

  private static void assertSame(Pose expected, Pose actual, double tolerance) {
    assertEquals(0, expected.distanceTo(actual), tolerance);
    assertEquals(0, Angles.difference(expected.theta(), actual.theta()), tolerance);
  }

  @Property
  void composingWhatIsSeenGivesTheOther(@ForAll("poses") Pose here, @ForAll("poses") Pose other) {
    assertSame(other, here.compose(here.relative(other)), 1e-9);
  }

  @Property
  void anglesStayBetweenMinusPiAndPi(@ForAll @DoubleRange(min = -1e6, max = 1e6) double angle) {
    double normal = Angles.normalise(angle);
    assertTrue(normal > -Math.PI && normal <= Math.PI);
    assertEquals(Math.sin(angle), Math.sin(normal), 1e-9);
    assertEquals(Math.cos(angle), Math.cos(normal), 1e-9);
  }

  @Property
  void movingIsTheLimitOfManySmallSteps(
      @ForAll("poses") Pose start,
      @ForAll @DoubleRange(min = -1, max = 1) double vx,
      @ForAll @DoubleRange(min = -1, max = 1) double vy,
      @ForAll @DoubleRange(min = -2, max = 2) double w) {
    Pose stepped = start;
    int steps = 2000;
    for (int i = 0; i < steps; i++) {
      double middle = stepped.theta() + w / steps / 2;
      Vec2 step = new Vec2(vx, vy).rotated(middle).times(1.0 / steps);
      stepped =
          new Pose(stepped.x() + step.x(), stepped.y() + step.y(), stepped.theta() + w / steps);
    }
    assertSame(stepped, start.advanced(new Twist(vx, vy, w), 1), 1e-6);
  }

  @Example
  void quarterCircleToTheLeftEndsBesideAndFacesNorth() {
    // radius 1 m: 1 m/s at 1 rad/s for pi/2 s
    Pose end = new Pose(0, 0, 0).advanced(new Twist(1, 0, 1), Math.PI / 2);
    assertSame(new Pose(1, 1, Math.PI / 2), end, 1e-12);
  }
}
