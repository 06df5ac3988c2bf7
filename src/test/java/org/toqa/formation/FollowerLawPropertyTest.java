package org.toqa.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/** Followers of a leader that drives one arc, over a link with delay, with bodies that lag. */
class FollowerLawPropertyTest {

  private static final double TOLERANCE = 0.05;
  private static final Pose START = new Pose(1, 2, 0.4);
  private static final double USUAL_DELAY = 0.02;

  @Property(tries = 100)
  void omniRobotComesToItsPlaceAndStaysThere(
      @ForAll @DoubleRange(min = 0, max = 0.3) double v,
      @ForAll @DoubleRange(min = -0.4, max = 0.4) double w,
      @ForAll @DoubleRange(min = -1, max = 1) double x,
      @ForAll @DoubleRange(min = -0.6, max = 0.6) double y,
      @ForAll @DoubleRange(min = 0.5, max = Gains.LARGEST) double gain,
      @ForAll @IntRange(min = 1, max = 5) int delayTicks,
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
    Gains gains = new Gains(gain, gain, 0.1, 0.5);
    Vec2 offset = new Vec2(x, y);
    Twist leader = new Twist(v, 0, w);
    FollowerTrial trial =
        new FollowerTrial(new SingleIntegratorLaw(gains), offset, TOLERANCE, delayTicks, seed);

    double settled = trial.worstError(START, leader, 0.04, 12, 20);

    // the delay that is not allowed for, at the place's speed, and 1 % of it from the wheels
    double speed = placeSpeed(leader, offset);
    double late = speed * (delayTicks * FollowerTrial.TICK - USUAL_DELAY);
    assertTrue(settled <= late + 0.02 * speed / gain + 0.008, "off its place by " + settled);
    assertTrue(trial.follower().trouble().isEmpty() || late > TOLERANCE / 2);
  }

  @Property(tries = 100)
  void robotThatCannotGoSidewaysComesToItsPlaceToo(
      @ForAll @DoubleRange(min = 0.1, max = 0.3) double v,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double w,
      @ForAll @DoubleRange(min = -1, max = 0) double x,
      @ForAll @DoubleRange(min = -0.6, max = 0.6) double y,
      @ForAll @IntRange(min = 1, max = 5) int delayTicks,
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
    Vec2 offset = new Vec2(x, y);
    Twist leader = new Twist(v, 0, w);
    FollowerTrial trial =
        new FollowerTrial(new NonHolonomicLaw(Gains.DEFAULT), offset, TOLERANCE, delayTicks, seed);

    double settled = trial.worstError(START, leader, 0.04, 20, 30);

    double late = placeSpeed(leader, offset) * (delayTicks * FollowerTrial.TICK - USUAL_DELAY);
    assertTrue(settled <= late + 0.012, "off its place by " + settled);
  }

  @Property(tries = 50)
  void noCorrectionIsFasterThanItMayBe(
      @ForAll @DoubleRange(min = -3, max = 3) double x,
      @ForAll @DoubleRange(min = -3, max = 3) double y,
      @ForAll @DoubleRange(min = -3, max = 3) double theta) {
    Twist omni =
        new SingleIntegratorLaw(Gains.DEFAULT).velocity(START, Twist.ZERO, new Pose(x, y, theta));
    Twist wheeled =
        new NonHolonomicLaw(Gains.DEFAULT).velocity(START, Twist.ZERO, new Pose(x, y, theta));

    assertTrue(Math.hypot(omni.vx(), omni.vy()) <= 0.1 + 1e-12);
    assertTrue(Math.abs(omni.w()) <= 0.5 + 1e-12);
    assertEquals(0, wheeled.vy());
    assertTrue(wheeled.vx() >= 0 && wheeled.vx() <= 0.1 + 1e-12);
    assertTrue(Math.abs(wheeled.w()) <= 0.5 + 1e-12);
  }

  @Example
  void gainsThatWouldSwingAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Gains(50, 3, 0.1, 0.5));
    assertThrows(IllegalArgumentException.class, () -> new Gains(2, 0, 0.1, 0.5));
    assertThrows(IllegalArgumentException.class, () -> new Gains(2, 3, Double.NaN, 0.5));
  }

  private static double placeSpeed(Twist leader, Vec2 offset) {
    Twist place = RigidMotion.at(offset, leader);
    return Math.hypot(place.vx(), place.vy());
  }
}
