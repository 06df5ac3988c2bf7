package org.toqa.agent.drive;

import java.util.ArrayList;
import java.util.List;
import org.toqa.avoidance.RangeSensors;
import org.toqa.avoidance.fouragents.DifferentialBody;
import org.toqa.avoidance.fouragents.FourAgents;
import org.toqa.avoidance.fouragents.FourAgentsSettings;
import org.toqa.avoidance.fouragents.RangeRing;
import org.toqa.avoidance.fouragents.StaticObstacle;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.motion.FreeZone;

/**
 * Drives a robot through a free zone by its four agents ({@link FourAgents}), from where it is to
 * where its path leaves the zone, and turns it there as the path goes on. The zone's border is a
 * wall: while something is near, the sensors read no farther than that, and the robot is never told
 * a velocity from which it could not stop inside. What the map shows in the zone is kept off the
 * same way.
 */
public final class FreeCrossing {

  /** Metres a second at most, as beside a path; the agents' lengths grow with what it stops in. */
  private static final double FASTEST = 0.25;

  /** Metres: nearer to where it leaves the zone the robot slows down, and only that counts. */
  private static final double ARRIVAL = 0.15;

  /**
   * What the robot would reach at full speed within so many seconds is dangerous: it has to turn
   * aside from what comes at half its speed.
   */
  private static final double DANGER_SECONDS = 2;

  /** Times what is dangerous: farther than that is far, as it is for the seed's sensors. */
  private static final double FAR = 2;

  /** Metres, radians; so near it is there. */
  private static final double THERE = 0.015;

  private static final double FACING = 0.02;

  /** It turns by so much of what is missing a second. */
  private static final double TURNING = 2;

  /** Metres nearer than ever before that count as progress. */
  private static final double PROGRESS = 0.05;

  /** Seconds without progress after which it gives up. */
  private static final double PATIENCE = 15;

  private final FreeZone zone;
  private final Pose exit;
  private final MotionLimits limits;
  private final DifferentialBody body;
  private final FourAgentsSettings settings;
  private final FourAgents agents;
  private final List<StaticObstacle> known;
  private final ContactGuard guard;
  private FourAgents.State state = FourAgents.State.START;
  private Twist told;
  private double nearest = Double.POSITIVE_INFINITY;
  private double patience = PATIENCE;
  private boolean isArrived;
  private boolean isOver;

  /**
   * @param exit where the robot shall leave the zone, map frame
   * @param radius of the robot, metres
   * @param track metres between its wheels
   * @param start how it moves now, in its own frame
   */
  public FreeCrossing(
      FreeZone zone, Pose exit, MotionLimits limits, double radius, double track, Twist start) {
    this.zone = zone;
    this.exit = exit;
    this.limits = limits;
    double speed = Math.min(Math.min(FASTEST, zone.speed()), limits.speed());
    this.body = new DifferentialBody(radius, track, speed, limits.acceleration());
    double danger = DANGER_SECONDS * speed;
    this.settings =
        FourAgentsSettings.of(body)
            .withArrival(ARRIVAL)
            .withDanger(danger)
            .withSensorRange(FAR * danger);
    this.agents = new FourAgents(settings);
    this.known =
        zone.obstacles().stream().map(o -> new StaticObstacle(o.centre(), o.radius())).toList();
    this.guard =
        new ContactGuard(
            new RangeSensors(settings.ring().beamsRightToLeft()), radius, limits.acceleration());
    this.told = start;
  }

  /** Whether the robot stands where it shall leave the zone, and faces as it shall. */
  public boolean isOver() {
    return isOver;
  }

  /** Whether it came no nearer to where it shall leave for so long that it gave up. */
  public boolean isStuck() {
    return patience <= 0;
  }

  /** Metres to where it leaves the zone, at the nearest so far. */
  public double nearest() {
    return nearest;
  }

  /**
   * One tick.
   *
   * @param robot where it is, map frame
   * @param ranges metres, one a sensor, from right behind over the front to left behind
   * @param seconds since the last tick
   * @param canMove false: it slows down and stands
   * @return how the robot shall move, in its own frame
   */
  public Twist step(Pose robot, List<Double> ranges, double seconds, boolean canMove) {
    double left = robot.position().distanceTo(exit.position());
    count(left, seconds, canMove);
    guard.look(robot, ranges, known, seconds);
    Twist wanted = Twist.ZERO;
    if (canMove && !isStuck() && !isOver) {
      isArrived |= left < THERE;
      wanted = isArrived ? turn(robot) : drive(robot, ranges, seconds);
    }
    told = within(robot, slewed(wanted, seconds));
    return told;
  }

  private void count(double left, double seconds, boolean canMove) {
    if (left < nearest - PROGRESS || isArrived) {
      nearest = Math.min(nearest, left);
      patience = isStuck() ? patience : PATIENCE;
    } else if (canMove) {
      patience -= seconds;
    }
  }

  private Twist turn(Pose robot) {
    double missing = Angles.difference(robot.theta(), exit.theta());
    isOver = Math.abs(missing) < FACING && Math.abs(told.w()) < FACING * TURNING;
    double rate = Math.min(limits.turnRate(), 2 * body.wheelSpeed() / body.track());
    return new Twist(0, 0, isOver ? 0 : Math.clamp(TURNING * missing, -rate, rate));
  }

  private Twist drive(Pose robot, List<Double> ranges, double seconds) {
    if (ranges.size() != RangeRing.SIZE) {
      return Twist.ZERO;
    }
    List<Double> seen =
        RangeRing.ordered(guard.filled(robot, ranges)).stream().map(this::seen).toList();
    FourAgents.Decision decision =
        agents.step(
            state,
            new FourAgents.Input(robot, walled(robot, seen), exit.position(), known, seconds));
    state = decision.state();
    Twist wanted = body.twist(decision.wheels());
    double speed = guard.retreating(robot, wanted.vx(), body.wheelSpeed());
    return new Twist(speed, 0, wanted.w());
  }

  /** What shows nothing is as far away as the agents count. */
  private double seen(double range) {
    return range >= RangeSensors.FARTHEST ? settings.sensorRange() : range;
  }

  /** What the sensors would read if the zone's border were a wall, where something is near. */
  private List<Double> walled(Pose robot, List<Double> seen) {
    boolean isAnythingNear = seen.stream().anyMatch(range -> range < settings.danger());
    if (!isAnythingNear) {
      return seen;
    }
    List<Double> ranges = new ArrayList<>();
    List<Pose> beams = settings.ring().beams();
    for (int i = 0; i < seen.size(); i++) {
      Pose beam = robot.compose(beams.get(i));
      double wall = Math.max(0, metresToBorder(beam));
      Vec2 there = beam.compose(new Pose(wall, 0, 0)).position();
      boolean isWayOut = there.distanceTo(exit.position()) < body.radius() + settings.danger();
      ranges.add(isWayOut ? seen.get(i) : Math.min(seen.get(i), wall));
    }
    return ranges;
  }

  private double metresToBorder(Pose beam) {
    double dx = Math.cos(beam.theta());
    double dy = Math.sin(beam.theta());
    double across =
        dx == 0
            ? Double.POSITIVE_INFINITY
            : ((dx > 0 ? zone.x() + zone.width() : zone.x()) - beam.x()) / dx;
    double along =
        dy == 0
            ? Double.POSITIVE_INFINITY
            : ((dy > 0 ? zone.y() + zone.height() : zone.y()) - beam.y()) / dy;
    return Math.min(across, along);
  }

  private Twist slewed(Twist wanted, double seconds) {
    double most = limits.acceleration() * seconds;
    double mostTurn = limits.turnAcceleration() * seconds;
    return new Twist(
        told.vx() + Math.clamp(wanted.vx() - told.vx(), -most, most),
        0,
        told.w() + Math.clamp(wanted.w() - told.w(), -mostTurn, mostTurn));
  }

  /** The same, slower where the robot could not stop inside the zone and off all that is there. */
  private Twist within(Pose robot, Twist wanted) {
    double v = wanted.vx();
    for (int i = 0; i < 8 && v != 0; i++) {
      Twist tried = new Twist(v, 0, wanted.w());
      if (isStopInside(robot, v) && guard.isSafe(robot, tried)) {
        return tried;
      }
      v = i == 7 ? 0 : v / 2;
    }
    return new Twist(0, 0, wanted.w());
  }

  /** Whether it stops inside, or comes no farther out than it is. */
  private boolean isStopInside(Pose robot, double v) {
    double metres = v * ContactGuard.REACTION + v * Math.abs(v) / (2 * limits.acceleration());
    Vec2 stop = robot.compose(new Pose(metres, 0, 0)).position();
    Vec2 here = robot.position();
    if (zone.inside(stop, body.radius()) < Math.min(0, zone.inside(here, body.radius()))) {
      return false;
    }
    for (StaticObstacle obstacle : known) {
      double touching = obstacle.radius() + body.radius();
      double gap = obstacle.centre().distanceTo(stop) - touching;
      if (gap < Math.min(0, obstacle.centre().distanceTo(here) - touching)) {
        return false;
      }
    }
    return true;
  }
}
