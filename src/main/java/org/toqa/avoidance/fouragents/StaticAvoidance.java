package org.toqa.avoidance.fouragents;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * The static avoidance agent: round a known obstacle on a limit cycle ({@link LimitCycle}), which
 * it tracks by sliding mode ({@link SlidingMode}).
 *
 * <p>The convergence circle has Rc = obstacle + robot + margin, less where the target is nearer, or
 * where half the margin on each side is left between two obstacles. The direction is chosen where
 * an obstacle is met, by the sign of the robot's y in a frame at the circle's centre turned toward
 * the target: above 0 clockwise, else counter-clockwise, the shorter way round. Obstacles whose
 * circles meet are gone round as one, always by the circle that is nearest, in the direction first
 * chosen (the seed has single obstacles only): that follows the border of all their circles
 * together, which no field of a single one does. An obstacle is in the way as long as the straight
 * line to the target meets its circle, and is left at the tangent.
 */
final class StaticAvoidance {

  /** Part of what the wheels can do that the reference leaves for tracking it. */
  private static final double RESERVE = 0.2;

  /** Part of the margin by which a line must come into a circle before the robot goes round. */
  private static final double GRAZE = 0.25;

  private static final double SMALL = 1e-6;

  private final FourAgentsSettings settings;
  private final SlidingMode tracker;

  StaticAvoidance(FourAgentsSettings settings) {
    this.settings = settings;
    DifferentialBody body = settings.body();
    // lengths by the margin; a turn at half the rate that the wheels can for a radian
    double most = 2 * body.wheelSpeed() / body.track();
    this.tracker =
        new SlidingMode(
            new SlidingMode.Reaching(
                0.5 * body.wheelSpeed() / settings.margin(),
                0.2 * body.wheelSpeed(),
                0.25 * settings.margin()),
            new SlidingMode.Reaching(2 * most, 0.1 * most, 0.1),
            1 / (body.wheelSpeed() * settings.margin()));
  }

  /** With the gains that are shipped. */
  SlidingMode tracker() {
    return tracker;
  }

  /**
   * An obstacle with its circle.
   *
   * @param outside metres from the circle to the robot, negative inside
   * @param isInTheWay whether the line to the target meets its circle
   */
  private record Circle(Vec2 centre, double radius, double outside, boolean isInTheWay) {
    boolean meets(Circle other) {
      return centre.distanceTo(other.centre) < radius + other.radius;
    }
  }

  /**
   * The obstacle to go round now.
   *
   * @param utility 0 to 1
   */
  record Threat(Vec2 centre, double radius, double utility) {}

  /**
   * What is in the way, if anything.
   *
   * @param isDriving whether this agent drives now
   */
  Optional<Threat> threat(
      Vec2 robot, Vec2 target, List<StaticObstacle> obstacles, boolean isDriving) {
    List<Circle> circles =
        obstacles.stream()
            .map(o -> circle(robot, target, o, air(o, obstacles), isDriving))
            .toList();
    Optional<Circle> nearest = Optional.empty();
    for (List<Circle> cluster : clusters(circles)) {
      if (cluster.stream().anyMatch(Circle::isInTheWay)) {
        for (Circle circle : cluster) {
          if (nearest.isEmpty() || circle.outside() < nearest.get().outside()) {
            nearest = Optional.of(circle);
          }
        }
      }
    }
    return nearest.map(
        c ->
            new Threat(
                c.centre(),
                c.radius(),
                Utilities.staticAvoidance(c.outside(), settings.approach(), settings.margin())));
  }

  private double touching(StaticObstacle obstacle) {
    return obstacle.radius() + settings.body().radius();
  }

  /** The margin of an obstacle: half the gap to another, where that leaves half of it. */
  private double air(StaticObstacle obstacle, List<StaticObstacle> obstacles) {
    double air = settings.margin();
    for (StaticObstacle other : obstacles) {
      double gap =
          obstacle.centre().distanceTo(other.centre()) - touching(obstacle) - touching(other);
      if (!other.equals(obstacle) && gap >= settings.margin()) {
        air = Math.min(air, gap / 2);
      }
    }
    return air;
  }

  private Circle circle(
      Vec2 robot, Vec2 target, StaticObstacle obstacle, double air, boolean isDriving) {
    double touching = touching(obstacle);
    double toTarget = obstacle.centre().distanceTo(target);
    double radius = Math.max(touching + SMALL, Math.min(touching + air, toTarget - SMALL));
    Vec2 inward = obstacle.centre().minus(robot);
    Vec2 ahead = target.minus(robot);
    boolean isAhead = inward.x() * ahead.x() + inward.y() * ahead.y() > 0;
    double entered = radius - obstacle.centre().distanceToLine(robot, target);
    double least = isDriving ? 0 : GRAZE * settings.margin();
    return new Circle(
        obstacle.centre(), radius, inward.norm() - radius, isAhead && entered > least);
  }

  /** The circles that meet, directly or by others between them, are together. */
  private static List<List<Circle>> clusters(List<Circle> circles) {
    List<List<Circle>> clusters = new ArrayList<>();
    for (Circle circle : circles) {
      List<Circle> joined = new ArrayList<>(List.of(circle));
      for (List<Circle> cluster : List.copyOf(clusters)) {
        if (cluster.stream().anyMatch(circle::meets)) {
          joined.addAll(cluster);
          clusters.remove(cluster);
        }
      }
      clusters.add(joined);
    }
    return clusters;
  }

  /**
   * The wheels, and what to keep for the next step.
   *
   * @param encounter what the last step kept; empty where the robot has just met something
   */
  record Result(Encounter encounter, WheelVelocities wheels) {}

  /**
   * One step round what is in the way.
   *
   * @param seconds since the last step
   */
  Result drive(
      Optional<Encounter> encounter, Threat threat, Pose robot, Vec2 target, double seconds) {
    boolean clockwise =
        encounter.map(Encounter::isClockwise).orElseGet(() -> isClockwise(threat, robot, target));
    LimitCycle cycle = new LimitCycle(threat.radius(), settings.convergence(), clockwise);
    Vec2 from = encounter.map(Encounter::reference).orElse(robot).position();
    // a reference that ran away, as while another agent drove, begins anew at the robot
    if (from.distanceTo(robot.position()) > settings.margin()) {
      from = robot.position();
    }
    SlidingMode.Reference reference = reference(cycle, threat.centre(), from);
    Twist along = new Twist(reference.speed(), 0, reference.turnRate());
    Pose next = reference.pose().advanced(along, seconds);
    WheelVelocities wheels = settings.body().wheels(tracker.velocity(robot, reference));
    return new Result(new Encounter(clockwise, next), wheels);
  }

  /** The shorter way round. */
  static boolean isClockwise(Threat threat, Pose robot, Vec2 target) {
    double axis = target.minus(threat.centre()).angle();
    return robot.position().minus(threat.centre()).rotated(-axis).y() > 0;
  }

  private SlidingMode.Reference reference(LimitCycle cycle, Vec2 centre, Vec2 at) {
    Vec2 inside = at.minus(centre);
    if (inside.norm() < SMALL) {
      inside = new Vec2(SMALL, 0); // the field rests at the centre
    }
    double curvature = cycle.curvature(inside);
    double track = settings.body().track();
    double fastest = (1 - RESERVE) * settings.body().wheelSpeed();
    double speed = fastest / (1 + Math.abs(curvature) * track / 2);
    double heading = Angles.normalise(cycle.velocity(inside).angle());
    return new SlidingMode.Reference(new Pose(at.x(), at.y(), heading), speed, speed * curvature);
  }
}
