package org.toqa.motion;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * An arc, a straight and an arc from one pose to another, forward only (Dubins, "On Curves of
 * Minimal Length with a Constraint on Average Curvature", 1957; the words LSL, LSR, RSL and RSR).
 *
 * @param radius of both arcs, metres
 * @param first angle of the first arc, radians, counter-clockwise
 * @param straight metres
 * @param last angle of the last arc, radians, counter-clockwise
 */
public record DubinsCurve(double radius, double first, double straight, double last) {
  private static final double ROUNDING = 1e-9;

  /** Those that there are between two poses in the same frame: two to four. */
  public static List<DubinsCurve> between(Pose from, Pose to, double radius) {
    List<DubinsCurve> curves = new ArrayList<>();
    for (int first = -1; first <= 1; first += 2) {
      for (int last = -1; last <= 1; last += 2) {
        Vec2 middle = from.compose(new Pose(0, first * radius, 0)).position();
        Vec2 lastMiddle = to.compose(new Pose(0, last * radius, 0)).position();
        Vec2 across = lastMiddle.minus(middle);
        double reach = across.norm();
        // of two circles on different sides of the straight: S^2 = D^2 - 4 R^2
        double gap = first == last ? 0 : 2 * radius;
        if (reach >= gap) {
          double along = reach < ROUNDING ? to.theta() : across.angle();
          double direction = along + (gap == 0 ? 0 : first * Math.asin(gap / reach));
          curves.add(
              new DubinsCurve(
                  radius,
                  turn(first, direction - from.theta()),
                  Math.sqrt(reach * reach - gap * gap),
                  turn(last, to.theta() - direction)));
        }
      }
    }
    return curves;
  }

  /** The angle as one that is turned to a side: 0 to a whole turn. */
  private static double turn(int side, double angle) {
    double turn = (side * angle) % (2 * Math.PI);
    double positive = turn < 0 ? turn + 2 * Math.PI : turn;
    return positive > 2 * Math.PI - ROUNDING || positive < ROUNDING ? 0 : side * positive;
  }

  /** Metres. */
  public double length() {
    return radius * turning() + straight;
  }

  /** Radians turned in all, to either side. */
  public double turning() {
    return Math.abs(first) + Math.abs(last);
  }

  /** How it is driven. */
  public List<Segment> segments(DriveSpeeds speeds) {
    List<Segment> segments = new ArrayList<>();
    arc(segments, speeds, first);
    if (straight > ROUNDING) {
      segments.add(new Segment(speeds.forward(), 0, straight / speeds.forward()));
    }
    arc(segments, speeds, last);
    return segments;
  }

  private void arc(List<Segment> segments, DriveSpeeds speeds, double angle) {
    if (angle != 0) {
      double rate = Math.min(speeds.forward() / radius, speeds.arcRate());
      segments.add(new Segment(radius * rate, Math.copySign(rate, angle), Math.abs(angle) / rate));
    }
  }
}
