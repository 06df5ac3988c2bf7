package org.toqa.motion;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Angles;
import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * Makes segments (v, w, t) of a curve: pairs of arcs that have its points and directions at their
 * ends and the same direction where they meet (Bolton, "Biarc curves", 1975). A curve is halved
 * until a pair is within a tolerance of each part, so the segments follow it as closely as is asked
 * for, and are few where it bends evenly.
 */
public final class BiarcFitter {
  /** Metres that segments may be beside the curve, where nobody said otherwise. */
  public static final double USUAL_TOLERANCE = 0.001;

  /** Points of a part that are looked at, and of each unit of its parameter. */
  private static final int PROBES = 16;

  /** Radians; a part of more than a unit whose arcs turn farther is halved. */
  private static final double LARGEST_ARC = Math.PI / 2;

  /** Radians; an arc that turns less is a straight: 0.02 micrometres beside it after 20 m. */
  private static final double STRAIGHT = 1e-9;

  /** Units of the parameter; shorter pieces are not halved. */
  private static final double SHORTEST = 1e-4;

  /** Radians; smaller turns on the spot are left out. */
  private static final double SMALLEST_TURN = 1e-6;

  private final DriveSpeeds speeds;

  /** Metres; half of what is promised, as the distance is measured at points. */
  private final double tolerance;

  public BiarcFitter(DriveSpeeds speeds) {
    this(speeds, USUAL_TOLERANCE);
  }

  /**
   * @param tolerance metres that segments may be beside the curve, above 0
   */
  public BiarcFitter(DriveSpeeds speeds, double tolerance) {
    this.speeds = speeds;
    this.tolerance = tolerance / 2;
  }

  /** One arc, by how it begins. */
  private record Arc(Pose start, double length, double curvature) {

    // kappa = 2 T x c / c^2, with T the direction and c the chord
    static Arc to(Pose start, Vec2 end) {
      Vec2 chord = end.minus(start.position());
      double squared = chord.x() * chord.x() + chord.y() * chord.y();
      Vec2 direction = new Vec2(1, 0).rotated(start.theta());
      double cross = direction.x() * chord.y() - direction.y() * chord.x();
      double dot = direction.x() * chord.x() + direction.y() * chord.y();
      double angle = 2 * Math.atan2(cross, dot);
      double curvature = squared == 0 ? 0 : 2 * cross / squared;
      double length =
          Math.abs(angle) < 1e-9 || curvature == 0 ? Math.sqrt(squared) : angle / curvature;
      return new Arc(start, length, curvature);
    }

    Pose at(double metres) {
      return start.advanced(new Twist(1, 0, curvature), metres);
    }

    Pose end() {
      return at(length);
    }
  }

  /**
   * Fits curves that are driven one after the other, with turns on the spot where directions do not
   * meet.
   *
   * @param start heading at the start, radians, counter-clockwise from map east
   */
  public Trajectory fit(double start, List<? extends PlaneCurve> curves) {
    List<Segment> segments = new ArrayList<>();
    double heading = start;
    for (PlaneCurve curve : curves) {
      turn(segments, Angles.difference(heading, curve.velocity(0).angle()));
      fit(segments, curve, 0, curve.end());
      heading = curve.velocity(curve.end()).angle();
    }
    Vec2 first = curves.isEmpty() ? Vec2.ZERO : curves.getFirst().position(0);
    return new Trajectory(new Pose(first.x(), first.y(), start), segments);
  }

  private void fit(List<Segment> segments, PlaneCurve curve, double from, double to) {
    Pose begin = pose(curve, from);
    Pose end = pose(curve, to);
    Vec2 joint = joint(begin, end);
    Arc first = Arc.to(begin, joint);
    Arc second = Arc.to(new Pose(joint.x(), joint.y(), first.end().theta()), end.position());
    if (to - from > SHORTEST && isFar(curve, from, to, first, second)) {
      double middle = (from + to) / 2;
      fit(segments, curve, from, middle);
      fit(segments, curve, middle, to);
      return;
    }
    add(segments, first);
    add(segments, second);
  }

  private static Pose pose(PlaneCurve curve, double u) {
    Vec2 position = curve.position(u);
    return new Pose(position.x(), position.y(), curve.velocity(u).angle());
  }

  /** Where the arcs meet: both tangents are equally long (d). */
  private static Vec2 joint(Pose begin, Pose end) {
    Vec2 t0 = new Vec2(1, 0).rotated(begin.theta());
    Vec2 t1 = new Vec2(1, 0).rotated(end.theta());
    Vec2 chord = end.position().minus(begin.position());
    double squared = chord.x() * chord.x() + chord.y() * chord.y();
    double along = chord.x() * (t0.x() + t1.x()) + chord.y() * (t0.y() + t1.y());
    double unlike = 1 - (t0.x() * t1.x() + t0.y() * t1.y());
    // 2 d^2 (T0 T1 - 1) - 2 d c (T0 + T1) + c^2 = 0, without cancelling
    double d = squared / (along + Math.sqrt(along * along + 2 * unlike * squared));
    Vec2 sum = begin.position().plus(t0.times(d)).plus(end.position()).minus(t1.times(d));
    return sum.times(0.5);
  }

  private boolean isFar(PlaneCurve curve, double from, double to, Arc first, Arc second) {
    double units = to - from;
    if (units > 1 && (isLarge(first) || isLarge(second))) {
      return true;
    }
    int probes = (int) Math.ceil(PROBES * units);
    return isFar(curve, from, to, first, second, PROBES)
        || (probes > PROBES && isFar(curve, from, to, first, second, probes));
  }

  private static boolean isLarge(Arc arc) {
    return !(Math.abs(arc.length() * arc.curvature()) <= LARGEST_ARC); // also where there is none
  }

  private boolean isFar(
      PlaneCurve curve, double from, double to, Arc first, Arc second, int probes) {
    for (int i = 1; i < probes; i++) {
      Vec2 point = curve.position(from + (to - from) * i / probes);
      if (!(Math.min(distance(first, point), distance(second, point)) <= tolerance)) {
        return true;
      }
    }
    return false;
  }

  /** From a point to an arc that is less than half a circle, metres. */
  private static double distance(Arc arc, Vec2 point) {
    Vec2 seen = point.minus(arc.start().position()).rotated(-arc.start().theta());
    double along = seen.x();
    if (Math.abs(arc.curvature()) > 1e-9) {
      // the angle about the centre, from the arc's start
      double k = arc.curvature();
      along = Math.atan2(k * seen.x(), 1 - k * seen.y()) / k;
    }
    return arc.at(Math.clamp(along, 0, arc.length())).position().distanceTo(point);
  }

  private void add(List<Segment> segments, Arc arc) {
    if (arc.length() <= 0) {
      return;
    }
    double angle = arc.length() * arc.curvature();
    double bend = Math.abs(angle) < STRAIGHT ? 0 : Math.abs(arc.curvature());
    double v = Math.min(speeds.forward(), bend == 0 ? speeds.forward() : speeds.arcRate() / bend);
    Segment last = segments.isEmpty() ? null : segments.getLast();
    if (bend == 0 && last != null && last.w() == 0) { // no turn on the spot: one goes straight on
      segments.set(segments.size() - 1, new Segment(v, 0, last.t() + arc.length() / v));
    } else {
      segments.add(new Segment(v, bend == 0 ? 0 : v * arc.curvature(), arc.length() / v));
    }
  }

  private void turn(List<Segment> segments, double angle) {
    if (Math.abs(angle) >= SMALLEST_TURN) {
      double rate = speeds.spotRate();
      segments.add(new Segment(0, Math.copySign(rate, angle), Math.abs(angle) / rate));
    }
  }
}
