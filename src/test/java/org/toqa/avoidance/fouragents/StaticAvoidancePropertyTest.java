package org.toqa.avoidance.fouragents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

class StaticAvoidancePropertyTest {
  private static final FourAgentsSettings SETTINGS =
      FourAgentsSettings.of(DifferentialBody.KHEPERA_II);

  /** By fine steps of Runge and Kutta, against the solution of r' = mu r (Rc^2 - r^2). */
  @Property(tries = 100)
  void theCircleIsReachedFromAnywhereButItsCentreAsTheSolutionSays(
      @ForAll @DoubleRange(min = 0.01, max = 3) double r0,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double angle,
      @ForAll @DoubleRange(min = 0.05, max = 1) double radius,
      @ForAll @DoubleRange(min = 0.3, max = 3) double convergence,
      @ForAll boolean clockwise) {
    LimitCycle cycle = new LimitCycle(radius, convergence, clockwise);
    Vec2 at = new Vec2(r0, 0).rotated(angle);
    double step = Math.min(1e-3, 0.1 * radius * radius / (convergence * r0 * r0));
    double time = 0;
    double turned = 0;
    while (time < 2 && time < 20_000 * step) {
      Vec2 k1 = cycle.velocity(at);
      Vec2 k2 = cycle.velocity(at.plus(k1.times(step / 2)));
      Vec2 k3 = cycle.velocity(at.plus(k2.times(step / 2)));
      Vec2 k4 = cycle.velocity(at.plus(k3.times(step)));
      Vec2 next = at.plus(k1.plus(k2.times(2)).plus(k3.times(2)).plus(k4).times(step / 6));
      turned += Angles.difference(at.angle(), next.angle());
      at = next;
      time += step;
    }
    double ratio = radius * radius / (r0 * r0);
    double expected = radius / Math.sqrt(1 + (ratio - 1) * Math.exp(-2 * convergence * time));

    assertEquals(expected, at.norm(), 1e-4 * radius);
    assertEquals(clockwise ? -time : time, turned, 1e-3);
  }

  /** The curvature of a short chord of the trajectory, by the turn of its direction. */
  @Property(tries = 200)
  void theCurvatureIsThatOfTheTrajectory(
      @ForAll @DoubleRange(min = 0.5, max = 2) double r,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double angle,
      @ForAll boolean clockwise) {
    LimitCycle cycle = new LimitCycle(1, 1, clockwise);
    Vec2 at = new Vec2(r, 0).rotated(angle);
    double step = 1e-5;
    Vec2 v = cycle.velocity(at);
    Vec2 next = at.plus(v.times(step));
    double turned = Angles.difference(v.angle(), cycle.velocity(next).angle());

    assertEquals(
        turned / (v.norm() * step), cycle.curvature(at), 1e-3 * (1 + Math.abs(turned) / step));
  }

  /**
   * The error dynamics of Kanayama, by small steps, without any limit of the wheels, with the gains
   * that are shipped and from all errors that a reference is kept with.
   */
  @Property(tries = 100)
  void theBoundaryLayerOfBothSurfacesIsReachedWithinTheTimeOfTheReachingLaw(
      @ForAll @DoubleRange(min = 0, max = 1) double off,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double towards,
      @ForAll @DoubleRange(min = -1.5, max = 1.5) double heading,
      @ForAll @DoubleRange(min = 0.1, max = 0.8) double share,
      @ForAll @DoubleRange(min = -1, max = 1) double turnRate) {
    Vec2 beside = new Vec2(off * SETTINGS.margin(), 0).rotated(towards);
    Pose robot = new Pose(beside.x(), beside.y(), heading);
    double speed = share * SETTINGS.body().wheelSpeed();
    SlidingMode law = new StaticAvoidance(SETTINGS).tracker();
    SlidingMode.Surfaces first =
        law.surfaces(robot, new SlidingMode.Reference(new Pose(0, 0, 0), speed, turnRate));
    double latest = Math.max(bound(first.s1(), law.along()), bound(first.s2(), law.turning()));
    SlidingMode.Surfaces last = after(latest, robot, speed, turnRate, UnaryOperator.identity());

    assertTrue(Math.abs(last.s1()) <= 1.05 * law.along().boundary(), () -> "s1 = " + last.s1());
    assertTrue(Math.abs(last.s2()) <= 1.05 * law.turning().boundary(), () -> "s2 = " + last.s2());
  }

  /** The same with wheels that can do no more than they can. */
  @Property(tries = 100)
  void withTheWheelsLimitsItIsReachedWithinFourSeconds(
      @ForAll @DoubleRange(min = 0, max = 1) double off,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double towards,
      @ForAll @DoubleRange(min = -1.5, max = 1.5) double heading,
      @ForAll @DoubleRange(min = 0.1, max = 0.8) double share,
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double turnRate) {
    Vec2 beside = new Vec2(off * SETTINGS.margin(), 0).rotated(towards);
    Pose robot = new Pose(beside.x(), beside.y(), heading);
    DifferentialBody body = SETTINGS.body();
    double speed = share * body.wheelSpeed();
    SlidingMode law = new StaticAvoidance(SETTINGS).tracker();
    SlidingMode.Surfaces last =
        after(4, robot, speed, turnRate, twist -> body.twist(body.wheels(twist)));

    assertTrue(Math.abs(last.s1()) <= law.along().boundary(), () -> "s1 = " + last.s1());
    assertTrue(Math.abs(last.s2()) <= law.turning().boundary(), () -> "s2 = " + last.s2());
  }

  private static SlidingMode.Surfaces after(
      double seconds, Pose begin, double speed, double turnRate, UnaryOperator<Twist> wheels) {
    SlidingMode law = new StaticAvoidance(SETTINGS).tracker();
    Pose robot = begin;
    Pose reference = new Pose(0, 0, 0);
    double step = 1e-4;
    for (double time = 0; time < seconds + step; time += step) {
      SlidingMode.Reference now = new SlidingMode.Reference(reference, speed, turnRate);
      robot = robot.advanced(wheels.apply(law.velocity(robot, now)), step);
      reference = reference.advanced(new Twist(speed, 0, turnRate), step);
    }
    return law.surfaces(robot, new SlidingMode.Reference(reference, speed, turnRate));
  }

  // s' = -Q s - P outside the layer: |s| = boundary at t = (1/Q) ln((Q |s0| + P) / (Q b + P))
  private static double bound(double s0, SlidingMode.Reaching law) {
    double q = law.gain();
    double p = law.switching();
    return Math.max(0, Math.log((q * Math.abs(s0) + p) / (q * law.boundary() + p)) / q);
  }

  /** Where an obstacle has just been met, and with a reference that the robot has lost. */
  @Property
  void theWheelsLimitsHold(
      @ForAll @DoubleRange(min = -0.4, max = 0.4) double x,
      @ForAll @DoubleRange(min = -0.4, max = 0.4) double y,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double heading,
      @ForAll @DoubleRange(min = 0, max = 2) double off,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double towards,
      @ForAll boolean hasMet) {
    StaticAvoidance avoidance = new StaticAvoidance(SETTINGS);
    StaticAvoidance.Threat threat = new StaticAvoidance.Threat(Vec2.ZERO, 0.15, 1);
    Pose robot = new Pose(x, y, heading);
    Vec2 reference = robot.position().plus(new Vec2(off * SETTINGS.margin(), 0).rotated(towards));
    Optional<Encounter> kept =
        hasMet
            ? Optional.empty()
            : Optional.of(new Encounter(true, new Pose(reference.x(), reference.y(), towards)));

    WheelVelocities wheels = avoidance.drive(kept, threat, robot, new Vec2(1, 0), 0.02).wheels();

    double most = SETTINGS.body().wheelSpeed();
    assertTrue(Math.abs(wheels.left()) <= most && Math.abs(wheels.right()) <= most);
  }

  /** In the seed's frame: y above 0 is left of the line from the obstacle to the target. */
  @Example
  void theShorterWayRoundIsTaken() {
    StaticAvoidance.Threat threat = new StaticAvoidance.Threat(Vec2.ZERO, 0.15, 1);
    Vec2 target = new Vec2(1, 0);

    assertTrue(StaticAvoidance.isClockwise(threat, new Pose(-1, 0.01, 0), target));
    assertFalse(StaticAvoidance.isClockwise(threat, new Pose(-1, -0.01, 0), target));
  }

  @Example
  void anObstacleBesideTheLineToTheTargetIsNoThreat() {
    StaticAvoidance avoidance = new StaticAvoidance(SETTINGS);
    StaticObstacle beside = new StaticObstacle(new Vec2(0.5, 0.3), 0.1);
    StaticObstacle ahead = new StaticObstacle(new Vec2(0.5, 0.05), 0.1);
    Vec2 target = new Vec2(1, 0);

    assertTrue(avoidance.threat(Vec2.ZERO, target, List.of(beside), false).isEmpty());
    assertTrue(avoidance.threat(Vec2.ZERO, target, List.of(ahead), false).isPresent());
    assertTrue(
        avoidance.threat(new Vec2(0.6, 0), target, List.of(ahead), true).isEmpty(),
        "it is behind the robot");
  }
}
