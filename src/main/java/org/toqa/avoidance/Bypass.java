package org.toqa.avoidance;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.avoidance.Corridor.Beside;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * Drives round something small on a path, in room beside that path which is the robot's own, and
 * comes back to the path behind it (Tanta, "Obstacle avoidance on the robot"): it steers along D =
 * (d_np + sum w_i d_i) / number, where d_np points to the next point of the line on which it passes
 * the thing, and what is too near pushes away.
 *
 * <p>It never drives more than 20 degrees beside its path, and faces where it drives: so far aside
 * look its own sensors, so they look where it comes to, and one still looks along the path and sees
 * how wide the thing is. Its steering follows from where it is alone, not from its speed, so it can
 * be driven ahead in thought: the robot goes on only as far as that keeps off all that it has seen.
 *
 * <p>A robot that can go sideways looks round meanwhile. One that cannot faces where it drives: it
 * is lent the same line, and sees of what it passes no more than that lets it.
 */
public final class Bypass {

  /** Metres between the rim and what was seen where it passes: a beam shows a point of a thing. */
  public static final double PASSING_GAP = 0.09;

  /**
   * Metres between the rim and what was seen, on the way there: a thing of 0.1 m that was seen in
   * its middle reaches 0.05 m aside of that, and is not touched.
   */
  public static final double LEAST_GAP = 0.06;

  /** Metres a second, at most, beside the path. */
  public static final double SPEED = 0.25;

  private static final double MAX_ANGLE = Math.toRadians(20);

  /** Radians: so far it looks to the side of what it passes, which may move, and to the other. */
  private static final double INWARD_GLANCE = Math.toRadians(45);

  private static final double OUTWARD_GLANCE = Math.toRadians(15);

  /** Radians a second; once to and fro takes a second. */
  private static final double GLANCE_RATE = 2;

  /** Metres to the point of the line that pulls. */
  private static final double LOOKAHEAD = 0.10;

  /** Metres; an angle of 20 degrees aside is reached within 0.07 m. */
  private static final double TURN_RADIUS = 0.20;

  /** Metres that it goes on beside a thing when its rim is past it. */
  private static final double BEHIND = 0.05;

  /** Metres aside for each metre to the end of the room, so that it is back by then. */
  private static final double RETURN_SLOPE = 0.3;

  private static final double STEP = 0.02;

  /** Metres before the place where it would be too near to something, where it stops. */
  private static final double STOP = Passage.STOP_GAP - LEAST_GAP;

  private static final double ROUNDING = 1e-9;

  /** Metres and radians; less than this is on the path. */
  private static final double ON_PATH = 0.003;

  private static final double ALONG_PATH = 0.03;

  private final double radius;
  private final boolean canLookRound;

  /** Metres to the left of the path where it passes what is on it; 0 where there is nothing. */
  private double passing;

  private double offset;
  private double angle;
  private double offsetRate;
  private double angleRate;

  /** Radians by which it faces to the left of where it drives. */
  private double glance;

  private double glanceRate;
  private boolean looksOutward;

  /**
   * The room beside the path.
   *
   * @param begin metres along the corridor, where it begins; below 0 behind the robot
   * @param end metres along the corridor, where it ends
   * @param left metres that the robot's middle may be to the left of its path there
   * @param right metres that it may be to the right
   */
  public record Room(double begin, double end, double left, double right) {

    private double left(double along) {
      return along < begin ? 0 : Math.clamp(RETURN_SLOPE * (end - along), 0, left);
    }

    private double right(double along) {
      return along < begin ? 0 : Math.clamp(RETURN_SLOPE * (end - along), 0, right);
    }
  }

  /**
   * How it gets by.
   *
   * @param blocking what is on its path, map frame
   * @param free metres along its path that it may go; infinite where it gets by
   * @param line where its middle will be, map frame
   */
  public record Way(List<Vec2> blocking, double free, List<Vec2> line) {
    public Way {
      blocking = List.copyOf(blocking);
      line = List.copyOf(line);
    }
  }

  /** Where it is beside the path, so many metres along it, and how it faces there. */
  private record Place(double along, double offset, double angle) {}

  /**
   * What it steers by.
   *
   * @param passing metres to the left of the path, while it passes
   * @param until metres along the path, where it has passed
   */
  private record Aim(Room room, double passing, double until, List<Beside> things) {

    /** Metres to the left of the path. */
    double offsetAt(double along) {
      return Math.clamp(along < until ? passing : 0, -room.right(along), room.left(along));
    }
  }

  /**
   * @param radius of the robot, metres
   * @param canLookRound whether it can turn away from where it drives
   */
  public Bypass(double radius, boolean canLookRound) {
    this.radius = radius;
    this.canLookRound = canLookRound;
  }

  /**
   * Lets time go on.
   *
   * @param corridor the path from where the robot would be on it
   * @param path how it would move on its path, in its own frame
   * @param seen all that was seen of late, map frame
   * @param seconds since the last step, at least 0
   * @param onward whether the robot may move: else it does not look round either, and stands
   */
  public Way step(
      Corridor corridor, Room room, Twist path, List<Vec2> seen, double seconds, boolean onward) {
    List<Beside> things = new ArrayList<>();
    List<Vec2> blocking = new ArrayList<>();
    double until = Double.NEGATIVE_INFINITY;
    for (Vec2 point : seen) {
      Beside thing = corridor.beside(point);
      things.add(thing);
      boolean isOnPath = Math.abs(thing.left()) < radius + Passage.CLEARANCE;
      double passed = thing.along() + radius + BEHIND;
      if (isOnPath && passed > 0) {
        blocking.add(point);
        until = Math.max(until, passed);
      }
    }
    passing = passing(room, things, until);
    Aim aim = new Aim(room, passing, until, things);
    double curvature = path.vx() == 0 ? 0 : path.w() / path.vx();
    Place now = new Place(0, offset, angle);
    Place next = next(now, Math.abs(path.vx()) * seconds, curvature, aim);
    offsetRate = seconds > 0 ? (next.offset() - offset) / seconds : 0;
    angleRate = seconds > 0 ? (next.angle() - angle) / seconds : 0;
    offset = next.offset();
    angle = next.angle();
    if (onward && canLookRound) {
      lookRound(!blocking.isEmpty(), seconds);
    } else {
      glanceRate = 0;
    }
    if (aim.offsetAt(0) == 0
        && glance == 0
        && Math.abs(offset) < ON_PATH
        && Math.abs(angle) < ALONG_PATH) {
      straighten();
    }
    return ahead(corridor, now, aim, seen, blocking);
  }

  private void lookRound(boolean isPassing, double seconds) {
    double outward = Math.signum(passing);
    double target = isPassing ? outward * (looksOutward ? OUTWARD_GLANCE : -INWARD_GLANCE) : 0;
    double most = GLANCE_RATE * seconds;
    double next = glance + Math.clamp(target - glance, -most, most);
    looksOutward ^= isPassing && next == target;
    glanceRate = seconds > 0 ? (next - glance) / seconds : 0;
    glance = next;
  }

  /** It is on its path, and faces along it. */
  private void straighten() {
    offset = 0;
    angle = 0;
    offsetRate = 0;
    angleRate = 0;
    glanceRate = 0;
  }

  /** On which side, and how far aside, it passes all that is on its path. */
  private double passing(Room room, List<Beside> things, double until) {
    if (until == Double.NEGATIVE_INFINITY) {
      return 0;
    }
    double widest = radius + PASSING_GAP;
    List<Beside> near =
        things.stream()
            .filter(thing -> thing.along() > -widest && thing.along() < until + widest)
            .toList();
    return near.stream()
        .flatMap(thing -> Stream.of(thing.left() + widest, thing.left() - widest))
        .filter(line -> line <= room.left() && line >= -room.right())
        .filter(line -> near.stream().allMatch(thing -> isKept(thing, line)))
        .min(Comparator.comparingDouble(line -> Math.abs(line - passing))) // on the same side
        .orElse(offset > 0 ? room.left() : offset < 0 ? -room.right() : 0);
  }

  private boolean isKept(Beside thing, double line) {
    return Math.abs(thing.left() - line) >= radius + gap(thing, PASSING_GAP) - ROUNDING;
  }

  /**
   * Metres between rim and thing that it keeps: from what is beside its path no more than there.
   */
  private double gap(Beside thing, double usual) {
    double onPath = Math.abs(thing.left()) - radius;
    return onPath < Passage.CLEARANCE ? usual : Math.min(onPath, usual);
  }

  /** Drives ahead in thought. */
  private Way ahead(Corridor corridor, Place from, Aim aim, List<Vec2> seen, List<Vec2> blocking) {
    List<Vec2> line = new ArrayList<>();
    List<Double> gaps = new ArrayList<>(seen.stream().map(_ -> Double.POSITIVE_INFINITY).toList());
    double length = corridor.length();
    Place at = from;
    while (true) {
      Vec2 middle = corridor.poseAt(at.along()).compose(new Pose(0, at.offset(), 0)).position();
      line.add(middle);
      if (comesTooNear(middle, seen, aim.things(), gaps)) {
        return new Way(blocking, Math.max(0, at.along() - STOP), line);
      }
      if (at.along() >= length) {
        return new Way(blocking, Double.POSITIVE_INFINITY, line);
      }
      at = next(at, STEP, corridor.curvatureAt(at.along()), aim);
    }
  }

  /** Whether it is too near to something there, and nearer than a step before. */
  private boolean comesTooNear(
      Vec2 middle, List<Vec2> seen, List<Beside> things, List<Double> gaps) {
    boolean isTooNear = false;
    for (int i = 0; i < seen.size(); i++) {
      double gap = middle.distanceTo(seen.get(i)) - radius;
      boolean comesNearer = gaps.get(i) < Double.POSITIVE_INFINITY && gap < gaps.get(i) - ROUNDING;
      isTooNear |= gap < gap(things.get(i), LEAST_GAP) - ON_PATH && comesNearer;
      gaps.set(i, gap);
    }
    return isTooNear;
  }

  /**
   * @param metres along the path
   * @param curvature of the path, radians a metre
   */
  private Place next(Place at, double metres, double curvature, Aim aim) {
    double scale = Math.max(0, 1 - curvature * at.offset()); // of what it drives beside a bend
    double driven = scale * metres / Math.cos(at.angle());
    double wanted = wantedAngle(at, aim);
    double most = driven / TURN_RADIUS;
    double turned = at.angle() + Math.clamp(wanted - at.angle(), -most, most);
    return new Place(
        at.along() + metres, at.offset() + scale * metres * Math.tan(at.angle()), turned);
  }

  /** Radians to the left of the path. */
  private double wantedAngle(Place at, Aim aim) {
    double reach = radius + PASSING_GAP;
    double pull = aim.offsetAt(at.along() + LOOKAHEAD) - at.offset();
    List<Vec2> near =
        aim.things().stream()
            .filter(thing -> thing.along() > at.along() - radius)
            .filter(thing -> distance(at, thing) < radius + gap(thing, PASSING_GAP))
            .map(thing -> new Vec2(thing.along() - at.along(), thing.left() - at.offset()))
            .toList();
    Vec2 direction = WeightedDirections.direction(new Vec2(LOOKAHEAD, pull), near, radius, reach);
    double wanted = Math.atan2(direction.y(), Math.max(direction.x(), 1e-6));
    double alongThere = at.along() + LOOKAHEAD;
    double most = angleTo(aim.room().left(alongThere) - at.offset());
    double least = angleTo(-aim.room().right(alongThere) - at.offset());
    return Math.clamp(Math.clamp(wanted, least, most), -MAX_ANGLE, MAX_ANGLE);
  }

  private static double distance(Place at, Beside thing) {
    return Math.hypot(thing.along() - at.along(), thing.left() - at.offset());
  }

  private static double angleTo(double aside) {
    return Math.atan2(aside, LOOKAHEAD);
  }

  /** Whether it drives on the path itself. */
  public boolean isOnPath() {
    return offset == 0 && angle == 0 && glance == 0;
  }

  /** Metres to the left of the path. */
  public double offset() {
    return offset;
  }

  /**
   * How fast the robot's place on its path may move, so that the robot is no faster than planned
   * beside it: a share of the planned speed.
   *
   * @param path how it would move on its path as planned
   */
  public double pace(Twist path) {
    if (path.vx() == 0) {
      return 1;
    }
    double beside = Math.abs(1 - path.w() / path.vx() * offset) / Math.cos(angle);
    return Math.min(1, Math.min(1, SPEED / Math.abs(path.vx())) / Math.max(beside, 0.1));
  }

  /**
   * Where the robot shall be.
   *
   * @param onPath where it would be on its path, in any frame
   */
  public Pose beside(Pose onPath) {
    return isOnPath() ? onPath : onPath.compose(new Pose(0, offset, angle + glance));
  }

  /**
   * How the robot shall move, in its own frame.
   *
   * @param onPath how it would move on its path, in its own frame
   */
  public Twist beside(Twist onPath) {
    if (isOnPath()) {
      return onPath;
    }
    // beside a point that turns, every point moves by w x r
    Vec2 velocity =
        new Vec2(onPath.vx() - onPath.w() * offset, onPath.vy() + offsetRate)
            .rotated(-angle - glance);
    return new Twist(velocity.x(), velocity.y(), onPath.w() + angleRate + glanceRate);
  }
}
