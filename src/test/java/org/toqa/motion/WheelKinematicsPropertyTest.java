package org.toqa.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

class WheelKinematicsPropertyTest {
  private static final ThreeWheelKinematics OMNI = ThreeWheelKinematics.DEFAULT;

  @Property
  void omniTwistOfSpeedsIsTheTwist(
      @ForAll @DoubleRange(min = -2, max = 2) double vx,
      @ForAll @DoubleRange(min = -2, max = 2) double vy,
      @ForAll @DoubleRange(min = -6, max = 6) double w) {
    Twist twist = OMNI.twist(OMNI.speeds(new Twist(vx, vy, w)));
    assertEquals(vx, twist.vx(), 1e-12);
    assertEquals(vy, twist.vy(), 1e-12);
    assertEquals(w, twist.w(), 1e-12);
  }

  @Property
  void omniSpeedsOfTwistAreTheSpeeds(
      @ForAll @DoubleRange(min = -23, max = 23) double a,
      @ForAll @DoubleRange(min = -23, max = 23) double b,
      @ForAll @DoubleRange(min = -23, max = 23) double c) {
    assertSpeeds(a, b, c, OMNI.speeds(OMNI.twist(new WheelSpeeds(a, b, c))));
  }

  private static void assertSpeeds(double a, double b, double c, WheelSpeeds speeds) {
    assertEquals(a, speeds.first(), 1e-12);
    assertEquals(b, speeds.second(), 1e-12);
    assertEquals(c, speeds.third(), 1e-12);
  }

  @Property
  void differentialTwistOfSpeedsIsTheTwist(
      @ForAll @DoubleRange(min = -2, max = 2) double v,
      @ForAll @DoubleRange(min = -6, max = 6) double w) {
    DifferentialKinematics wheels = new DifferentialKinematics(0.05, 0.3);
    Twist twist = wheels.twist(wheels.speeds(new Twist(v, 0, w)));
    assertEquals(v, twist.vx(), 1e-12);
    assertEquals(0, twist.vy());
    assertEquals(w, twist.w(), 1e-12);
  }

  @Example
  void straightAheadTheWheelOnTheXAxisRests() {
    // sqrt(3)/2 * 0.4 m/s / 0.04 m = 8.66 rad/s
    assertSpeeds(5 * Math.sqrt(3), 0, -5 * Math.sqrt(3), OMNI.speeds(new Twist(0.4, 0, 0)));
  }

  @Example
  void onTheSpotAllWheelsTurnAlike() {
    // 0.10 m * 2 rad/s / 0.04 m = 5 rad/s
    assertSpeeds(5, 5, 5, OMNI.speeds(new Twist(0, 0, 2)));
  }

  @Example
  void twoWheelsOnOneAxleCannotGoSideways() {
    DifferentialKinematics wheels = new DifferentialKinematics(0.05, 0.3);
    assertThrows(IllegalArgumentException.class, () -> wheels.speeds(new Twist(0, 0.1, 0)));
  }

  @Property(tries = 200)
  void odometryFollowsAnArcWithinTheEncodersResolution(
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double vx,
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double vy,
      @ForAll @DoubleRange(min = -1.5, max = 1.5) double w,
      @ForAll int counterAtStart) {
    Pose start = new Pose(3, -2, 0.7);
    Twist twist = new Twist(vx, vy, w);
    WheelSpeeds speeds = OMNI.speeds(twist);
    double[] radiansASecond = {speeds.first(), speeds.second(), speeds.third()};
    Odometry odometry =
        new Odometry(
            OMNI,
            Odometry.COUNTS_PER_WHEEL_TURN,
            start,
            counterAtStart,
            counterAtStart,
            counterAtStart);
    for (int tick = 1; tick <= 500; tick++) { // 5 s in steps of 10 ms
      int[] counts = new int[3];
      for (int i = 0; i < 3; i++) {
        double turns = radiansASecond[i] * tick * 0.01 / (2 * Math.PI);
        counts[i] = counterAtStart + (int) Math.round(turns * Odometry.COUNTS_PER_WHEEL_TURN);
      }
      odometry.update(counts);
    }
    Pose expected = start.advanced(twist, 5);
    // a count is 2 pi 0.04 m / 2808 = 0.09 mm at the wheel
    assertEquals(expected.x(), odometry.pose().x(), 1e-3);
    assertEquals(expected.y(), odometry.pose().y(), 1e-3);
    assertEquals(0, odometry.pose().relative(expected).theta(), 2e-3);
  }
}
