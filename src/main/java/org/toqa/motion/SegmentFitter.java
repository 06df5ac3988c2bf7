package org.toqa.motion;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;

/**
 * Makes curve segments (v, w, t) of a path of straight legs (Tanta, "From path to curve segments"):
 * straights at constant speed, an arc round every corner so that the robot always faces forward, a
 * turn on the spot where the path asks for one or the robot does not face the first leg.
 *
 * <p>With L the corner length, an arc begins L/2 before its corner and ends L/2 after it, on a
 * circle of radius R = (L/2) / tan(angle/2). On a leg that is too short for that, its arcs begin
 * and end nearer to their corners, so that they never overlap. Corners sharper than 135 degrees,
 * where the circle would shrink to a point, are turned on the spot.
 */
public final class SegmentFitter {
  private static final double SHARPEST_ARC = 3 * Math.PI / 4 + 1e-6;

  /** Legs below this length, metres, are points. */
  private static final double SHORTEST_LEG = 1e-4;

  /** Turns below this angle, radians, are no turns: 0.02 mm after 20 m. */
  private static final double SMALLEST_TURN = 1e-6;

  private final DriveSpeeds speeds;
  private final double cornerLength;

  /**
   * @param cornerLength L in metres: a grid's cell size
   * @throws IllegalArgumentException if it is not positive and finite
   */
  public SegmentFitter(DriveSpeeds speeds, double cornerLength) {
    if (!(cornerLength > 0) || Double.isInfinite(cornerLength)) {
      throw new IllegalArgumentException(
          "A corner's length is a positive number of metres, not " + cornerLength + ".");
    }
    this.speeds = speeds;
    this.cornerLength = cornerLength;
  }

  /**
   * @param start where the robot really is, map frame; the first leg begins there
   * @param waypoints where the legs bend and where they end
   * @throws IllegalArgumentException if a coordinate is not finite
   */
  public Trajectory fit(Pose start, List<Waypoint> waypoints) {
    return new Trajectory(start, segments(start, legs(start, waypoints)));
  }

  /**
   * The same, and at the end a turn on the spot.
   *
   * @param heading of the robot at the end, radians, counter-clockwise from map east
   * @throws IllegalArgumentException if a coordinate or the heading is not finite
   */
  public Trajectory fit(Pose start, List<Waypoint> waypoints, double heading) {
    requireFinite(heading);
    List<Leg> legs = legs(start, waypoints);
    List<Segment> segments = segments(start, legs);
    double arrival = legs.isEmpty() ? start.theta() : legs.getLast().direction();
    turnOnSpot(segments, Angles.difference(arrival, heading));
    return new Trajectory(start, segments);
  }

  /**
   * A straight part between two points.
   *
   * @param length metres
   * @param direction radians, counter-clockwise from the map's x axis
   * @param turnAtEnd whether the robot turns on the spot at its end
   */
  private record Leg(double length, double direction, boolean turnAtEnd) {}

  private static List<Leg> legs(Pose start, List<Waypoint> waypoints) {
    requireFinite(start.x(), start.y(), start.theta());
    List<Leg> legs = new ArrayList<>();
    Vec2 from = start.position();
    for (Waypoint to : waypoints) {
      Vec2 leg = to.position().minus(from);
      requireFinite(leg.x(), leg.y());
      if (leg.norm() >= SHORTEST_LEG) {
        legs.add(new Leg(leg.norm(), leg.angle(), to.turnOnSpot()));
        from = to.position();
      }
    }
    return legs;
  }

  private List<Segment> segments(Pose start, List<Leg> legs) {
    List<Segment> segments = new ArrayList<>();
    double heading = start.theta();
    double usedByArc = 0; // metres of this leg that the last corner's arc has taken
    for (int i = 0; i < legs.size(); i++) {
      Leg leg = legs.get(i);
      if (usedByArc == 0) {
        turnOnSpot(segments, Angles.difference(heading, leg.direction()));
      }
      double tangent = tangent(legs, i);
      straight(segments, leg.length() - usedByArc - tangent);
      if (tangent > 0) {
        arc(segments, tangent, Angles.difference(leg.direction(), legs.get(i + 1).direction()));
      }
      heading = leg.direction();
      usedByArc = tangent;
    }
    return segments;
  }

  /** Metres before and after the end of leg i that its arc takes; 0 where there is no arc. */
  private double tangent(List<Leg> legs, int i) {
    if (!endsInArc(legs, i)) {
      return 0;
    }
    double before = legs.get(i).length() / (i > 0 && endsInArc(legs, i - 1) ? 2 : 1);
    double after = legs.get(i + 1).length() / (endsInArc(legs, i + 1) ? 2 : 1);
    return Math.min(cornerLength / 2, Math.min(before, after));
  }

  private static boolean endsInArc(List<Leg> legs, int i) {
    if (i + 1 >= legs.size() || legs.get(i).turnAtEnd()) {
      return false;
    }
    double angle =
        Math.abs(Angles.difference(legs.get(i).direction(), legs.get(i + 1).direction()));
    return angle >= SMALLEST_TURN && angle <= SHARPEST_ARC;
  }

  // R = (L/2) / tan(angle/2), t = angle / w, v = R w   (Tanta, "From path to curve segments")
  private void arc(List<Segment> segments, double tangent, double angle) {
    double radius = tangent / Math.tan(Math.abs(angle) / 2);
    double rate = Math.min(speeds.forward() / radius, speeds.arcRate());
    segments.add(new Segment(radius * rate, Math.copySign(rate, angle), Math.abs(angle) / rate));
  }

  private void straight(List<Segment> segments, double length) {
    if (length >= SHORTEST_LEG / 100) {
      segments.add(new Segment(speeds.forward(), 0, length / speeds.forward()));
    }
  }

  private void turnOnSpot(List<Segment> segments, double angle) {
    if (Math.abs(angle) >= SMALLEST_TURN) {
      segments.add(
          new Segment(
              0, Math.copySign(speeds.spotRate(), angle), Math.abs(angle) / speeds.spotRate()));
    }
  }

  private static void requireFinite(double... numbers) {
    for (double number : numbers) {
      if (!Double.isFinite(number)) {
        throw new IllegalArgumentException("A path has finite coordinates, not " + number + ".");
      }
    }
  }
}
