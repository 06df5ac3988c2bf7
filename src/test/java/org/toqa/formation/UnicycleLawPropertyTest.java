package org.toqa.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/** A robot that turns and drives ahead, after a place that does so too. */
class UnicycleLawPropertyTest {
  private static final UnicycleLaw LAW = new UnicycleLaw();
  private static final double STEP = 0.001;

  /** The paper's equations, written out in the map's axes, with the gains for this speed. */
  @Property(tries = 200)
  void lawIsThatOfThePaper(
      @ForAll @DoubleRange(min = -0.45, max = 0.45) double v,
      @ForAll @DoubleRange(min = -2, max = 2) double w,
      @ForAll @DoubleRange(min = -0.01, max = 0.01) double x,
      @ForAll @DoubleRange(min = -0.01, max = 0.01) double y,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double turned,
      @ForAll @DoubleRange(min = -3, max = 3) double theta) {
    Pose place = new Pose(x, y, theta + turned);

    Twist twist = LAW.velocity(place, new Twist(v, 0, w), new Pose(0, 0, theta));

    double along = Math.cos(theta) * x + Math.sin(theta) * y;
    double aside = -Math.sin(theta) * x + Math.cos(theta) * y;
    double k = Math.max(3, 10 * Math.abs(v));
    assertEquals(v * Math.cos(turned) + 3 * along, twist.vx(), 1e-9);
    assertEquals(0, twist.vy());
    assertEquals(w + v * asideGain(v) * aside + k * Math.sin(turned), twist.w(), 1e-9);
  }

  /** Kanayama's V falls on every way that the place goes, also back and on the spot. */
  @Property(tries = 60)
  void robotComesNearerToItsPlaceAllTheTime(
      @ForAll @DoubleRange(min = -1.5, max = 1.5) double v,
      @ForAll @DoubleRange(min = -2, max = 2) double w,
      @ForAll @DoubleRange(min = -0.02, max = 0.02) double x,
      @ForAll @DoubleRange(min = -0.02, max = 0.02) double y,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double turned) {
    Twist placeTwist = new Twist(v, 0, w);
    Pose place = new Pose(0, 0, 0);
    Pose robot = new Pose(x, y, turned);
    double most = distance(place, robot, v);
    for (int i = 0; i < 3000; i++) {
      robot = robot.advanced(LAW.velocity(place, placeTwist, robot), STEP);
      place = place.advanced(placeTwist, STEP);
      double now = distance(place, robot, v);
      assertTrue(now <= most + 1e-6, "from " + most + " to " + now);
      most = Math.min(most, now);
    }
  }

  /** On a metre of path, whatever the speed, what is beside it is made good without swinging. */
  @Property(tries = 60)
  void robotIsBackOnItsPathAfterAMetre(
      @ForAll @DoubleRange(min = 0.05, max = 0.5) double v,
      @ForAll @DoubleRange(min = -0.05, max = 0.05) double y) {
    Twist placeTwist = new Twist(v, 0, 0);
    Pose place = new Pose(0, 0, 0);
    Pose robot = new Pose(0, y, 0);
    double beyond = 0;
    while (place.x() < 1) {
      robot = robot.advanced(LAW.velocity(place, placeTwist, robot), STEP);
      place = place.advanced(placeTwist, STEP);
      beyond = Math.max(beyond, -robot.y() * Math.signum(y));
    }
    assertEquals(0, robot.y(), 0.05 * Math.abs(y) + 1e-6);
    assertTrue(beyond <= 0.02 * Math.abs(y) + 1e-6, "swung over by " + beyond);
  }

  /** 1/m2: k^2 = 4 k_y v^2 is where nothing swings. */
  private static double asideGain(double v) {
    double k = Math.clamp(10 * Math.abs(v), 3, 5);
    return v == 0 ? 400 : Math.min(400, k * k / (4 * v * v));
  }

  // V = (e_x^2 + e_y^2) / 2 + (1 - cos e_th) / k_y
  private static double distance(Pose place, Pose robot, double v) {
    double apart = place.distanceTo(robot);
    return apart * apart / 2 + (1 - Math.cos(place.theta() - robot.theta())) / asideGain(v);
  }
}
