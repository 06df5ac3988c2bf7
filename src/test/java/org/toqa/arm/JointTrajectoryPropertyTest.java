package org.toqa.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;

class JointTrajectoryPropertyTest {
  private static final int SAMPLES = 400;

  @Provide
  Arbitrary<Arm> arms() {
    return ArmsForTests.limited();
  }

  private static JointAngles stand(Arm arm, double shoulder, double elbow) {
    return new JointAngles(
        arm.shoulder().least() + shoulder * (arm.shoulder().most() - arm.shoulder().least()),
        arm.elbow().least() + elbow * (arm.elbow().most() - arm.elbow().least()));
  }

  @Test
  void slowerJointDecides() {
    Arm arm = ArmsForTests.free(0.3, 0.2, new org.toqa.geometry.Pose(0, 0, 0));
    // 3 rad at 1.5 rad/s and 4 rad/s2: 3 / 1.5 + 1.5 / 4 = 2.375 s
    assertEquals(
        2.375,
        JointTrajectory.between(arm, JointAngles.ZERO, new JointAngles(3, 0.1)).duration(),
        1e-12);
    // 0.2 rad never come to full speed: 2 sqrt(0.2 / 5) = 0.4 s
    assertEquals(
        0.4,
        JointTrajectory.between(arm, JointAngles.ZERO, new JointAngles(0, 0.2)).duration(),
        1e-12);
  }

  @Property(tries = 200)
  void limitsHoldAllTheWayAndBothJointsEndTogether(
      @ForAll("arms") Arm arm,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double a,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double b,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double c,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double d) {
    JointAngles from = stand(arm, a, b);
    JointAngles to = stand(arm, c, d);
    JointTrajectory way = JointTrajectory.between(arm, from, to);
    checkLimits(arm, way);
    assertEquals(0, way.at(0).angles().minus(from).largest(), 1e-12);
    assertEquals(0, way.at(way.duration()).angles().minus(to).largest(), 1e-12);
    assertEquals(0, way.at(way.duration()).rates().largest(), 1e-12);
  }

  @Property(tries = 200)
  void brakedOneStaysOnTheWayWithinTheLimits(
      @ForAll("arms") Arm arm,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double a,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double c,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double d,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1.1) double when) {
    JointTrajectory way = JointTrajectory.between(arm, stand(arm, a, 1 - a), stand(arm, c, d));
    double moment = when * way.duration();
    JointTrajectory braked = way.brakedFrom(moment);
    checkLimits(arm, braked);
    assertEquals(0, braked.at(0).angles().minus(way.at(moment).angles()).largest(), 1e-9);
    assertEquals(0, braked.at(0).rates().minus(way.at(moment).rates()).largest(), 1e-9);
    // it never takes longer than the way itself has left, nor goes beyond its end
    assertTrue(braked.duration() <= Math.max(0, way.duration() - moment) + 1e-9);
    double left = way.end().minus(way.at(moment).angles()).largest();
    assertTrue(braked.change().largest() <= left + 1e-9);
  }

  /** Apart from the formulas: rates are differences of angles, accelerations of rates. */
  private static void checkLimits(Arm arm, JointTrajectory way) {
    double duration = way.duration();
    assertTrue(Double.isFinite(duration) && duration >= 0);
    double step = duration / SAMPLES;
    JointTrajectory.Moment before = way.at(0);
    for (int i = 0; i <= SAMPLES; i++) {
      JointTrajectory.Moment now = way.at(i * step);
      assertTrue(arm.allows(now.angles()), () -> "angles " + now.angles());
      checkRate(arm.shoulder(), now.rates().shoulder());
      checkRate(arm.elbow(), now.rates().elbow());
      if (i > 0 && step > 1e-6) {
        JointAngles moved = now.angles().minus(before.angles()).times(1 / step);
        checkRate(arm.shoulder(), moved.shoulder());
        checkRate(arm.elbow(), moved.elbow());
        JointAngles change = now.rates().minus(before.rates()).times(1 / step);
        assertTrue(Math.abs(change.shoulder()) <= arm.shoulder().maxAcceleration() * 1.0001);
        assertTrue(Math.abs(change.elbow()) <= arm.elbow().maxAcceleration() * 1.0001);
        JointAngles mean = now.rates().plus(before.rates()).times(0.5);
        double most = arm.shoulder().maxAcceleration() + arm.elbow().maxAcceleration();
        assertEquals(0, moved.minus(mean).largest(), most * step + 1e-9);
      }
      before = now;
    }
  }

  private static void checkRate(JointLimits joint, double rate) {
    assertTrue(Math.abs(rate) <= joint.maxRate() * 1.0001 + 1e-9, () -> "rate " + rate);
  }
}
