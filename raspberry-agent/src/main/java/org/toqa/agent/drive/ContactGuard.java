package org.toqa.agent.drive;

import java.util.ArrayList;
import java.util.List;
import org.toqa.avoidance.RangeSensors;
import org.toqa.avoidance.fouragents.StaticObstacle;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * Lets a round robot drive only as fast as it can stop before all that its sensors saw a short
 * while ago, wherever that has gone meanwhile (passive motion safety, see {@link
 * org.toqa.avoidance.SafePace}; here nobody says how the things move). From what is too near
 * already it may only go away or along. Who stands may still be driven into.
 */
final class ContactGuard {

  /** Seconds until the wheels turn as they were told. */
  static final double REACTION = 0.15;

  /** Metres a second: as fast as things may move, in any direction. */
  private static final double DRIFT = 0.125;

  /** Seconds after which a thing that was not seen again is not taken to have gone farther. */
  private static final double DRIFTING = 0.5;

  /** Metres that are always left free: noise of sensors and pose. */
  private static final double MARGIN = 0.02;

  /** Seconds; what was not seen for longer is forgotten. */
  private static final double MEMORY = 4.5;

  /** Seconds for which a thing may be between two beams. */
  private static final double HIDDEN = 1;

  /** Metres; points so near to each other are one. */
  private static final double SAME = 0.03;

  /** Metres from its rim: from what comes nearer than that ahead or behind the robot backs away. */
  private static final double CLOSE = 0.2;

  /** Cosine of the angle from its axis up to which that is ahead or behind. */
  private static final double ALONG = 0.5;

  /** Seconds between two places that are looked at. */
  private static final double SAMPLE = 0.05;

  private final RangeSensors sensors;
  private final double radius;
  private final double braking;
  private List<Sighting> sightings = List.of();

  /**
   * @param radius of the robot, metres
   * @param braking metres a second squared
   */
  ContactGuard(RangeSensors sensors, double radius, double braking) {
    this.sensors = sensors;
    this.radius = radius;
    this.braking = braking;
  }

  /**
   * A point of a thing.
   *
   * @param seconds since it was seen there
   * @param drift metres a second, as fast as it may move
   */
  private record Sighting(Vec2 point, double seconds, double drift) {
    Sighting older(double by) {
      return new Sighting(point, seconds + by, drift);
    }

    /** Metres within which the point may be, so many seconds from now. */
    double reach(double after) {
      return drift * (Math.min(seconds, DRIFTING) + after);
    }
  }

  /**
   * Notes what is seen.
   *
   * @param robot where it is, map frame
   * @param ranges metres, in the order of its sensors
   * @param known things that stand
   * @param seconds since the last look
   */
  void look(Pose robot, List<Double> ranges, List<StaticObstacle> known, double seconds) {
    // what is nearer than they can measure may touch
    List<Double> least = ranges.stream().map(r -> r > RangeSensors.NEAREST ? r : 0).toList();
    List<Sighting> kept = new ArrayList<>();
    for (Vec2 point : sensors.detections(least, robot)) {
      boolean stands =
          known.stream().anyMatch(o -> o.centre().distanceTo(point) < o.radius() + SAME);
      kept.add(new Sighting(point, 0, stands ? 0 : DRIFT));
    }
    int fresh = kept.size();
    for (Sighting old : sightings) {
      boolean isSeenAgain =
          kept.subList(0, fresh).stream().anyMatch(s -> s.point.distanceTo(old.point) < SAME);
      if (!isSeenAgain
          && old.seconds + seconds < MEMORY
          && !sensors.areThrough(ranges, robot, old.point)) {
        kept.add(old.older(seconds));
      }
    }
    sightings = List.copyOf(kept);
  }

  /**
   * The ranges as if no thing could hide between two beams: what was seen a moment ago is read by
   * the sensor that looks most toward it.
   *
   * @param ranges metres, from right behind over the front to left behind
   * @return the same, none larger
   */
  List<Double> filled(Pose robot, List<Double> ranges) {
    List<Double> filled = new ArrayList<>(ranges);
    for (Sighting thing : sightings) {
      if (thing.seconds > 0 && thing.seconds < HIDDEN && thing.drift > 0) {
        Vec2 seen = thing.point.minus(robot.position()).rotated(-robot.theta());
        int nearest = 0;
        for (int i = 1; i < filled.size(); i++) {
          nearest = off(seen, i) < off(seen, nearest) ? i : nearest;
        }
        double range = Math.max(0, seen.norm() - radius);
        filled.set(nearest, Math.min(filled.get(nearest), range));
      }
    }
    return filled;
  }

  private double off(Vec2 seen, int sensor) {
    return Math.abs(Angles.difference(seen.angle(), sensors.beams().get(sensor).theta()));
  }

  /**
   * The speed along its heading with which the robot leaves what is close.
   *
   * @param wanted metres a second
   * @param fastest metres a second
   * @return wanted, where nothing is close ahead or behind
   */
  double retreating(Pose robot, double wanted, double fastest) {
    double nearest = radius + CLOSE;
    double speed = wanted;
    for (Sighting thing : sightings) {
      Vec2 seen = thing.point.minus(robot.position()).rotated(-robot.theta());
      double distance = seen.norm();
      if (thing.seconds == 0 && thing.drift > 0 && distance < nearest) {
        nearest = distance;
        double along = seen.x() / distance;
        speed = along > ALONG ? -fastest : along < -ALONG ? fastest : wanted;
      }
    }
    return speed;
  }

  /**
   * Whether the robot, told so now and to stop right after, touches nothing until it stands.
   *
   * @param velocity robot frame
   */
  boolean isSafe(Pose robot, Twist velocity) {
    double speed = Math.abs(velocity.vx());
    double end = REACTION + speed / braking;
    Pose pose = robot;
    for (double t = 0; t < end; t += SAMPLE) {
      double share = Math.clamp((end - t) * braking / speed, 0, 1);
      Pose next = pose.advanced(new Twist(velocity.vx() * share, 0, velocity.w() * share), SAMPLE);
      if (!isSafe(pose.position(), next.position(), t + SAMPLE)) {
        return false;
      }
      pose = next;
    }
    return true;
  }

  private boolean isSafe(Vec2 from, Vec2 to, double after) {
    for (Sighting thing : sightings) {
      double distance = thing.point.distanceTo(to);
      boolean comesNearer = distance < thing.point.distanceTo(from);
      if (comesNearer && distance < radius + MARGIN + thing.reach(after)) {
        return false;
      }
    }
    return true;
  }
}
