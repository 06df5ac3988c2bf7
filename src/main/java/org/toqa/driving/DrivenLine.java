package org.toqa.driving;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.toqa.geometry.Angles;
import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * Curves that follow each other without a turn on the spot, by the metres along them: poses at
 * close distances, and between two of them straight lines. Immutable.
 */
public final class DrivenLine {
  /** Metres between poses. */
  private static final double APART = 0.005;

  /** Metres; poses that are closer are one. */
  private static final double SAME = 1e-9;

  private static final int LOOKS_OF_SPAN = 8;

  private final List<Pose> poses;
  private final double[] passed;

  private DrivenLine(List<Pose> poses) {
    this.poses = List.copyOf(poses);
    this.passed = new double[poses.size()];
    for (int i = 1; i < passed.length; i++) {
      passed[i] = passed[i - 1] + poses.get(i - 1).distanceTo(poses.get(i));
    }
  }

  /**
   * Lays it out.
   *
   * @param curves each begins where the one before ends, in its direction; at least one
   */
  public static DrivenLine of(List<? extends PlaneCurve> curves) {
    List<Pose> poses = new ArrayList<>();
    for (PlaneCurve curve : curves) {
      int spans = (int) Math.max(1, Math.ceil(curve.end()));
      for (int span = 0; span < spans; span++) {
        double begin = curve.end() * span / spans;
        double end = curve.end() * (span + 1) / spans;
        int pieces = pieces(curve, begin, end);
        for (int i = 0; i <= pieces; i++) {
          add(poses, curve, begin + (end - begin) * i / pieces);
        }
      }
    }
    return new DrivenLine(poses);
  }

  private static int pieces(PlaneCurve curve, double begin, double end) {
    double fastest = 0;
    for (int i = 0; i <= LOOKS_OF_SPAN; i++) {
      double u = begin + (end - begin) * i / LOOKS_OF_SPAN;
      fastest = Math.max(fastest, curve.velocity(u).norm());
    }
    return (int) Math.max(1, Math.ceil(fastest * (end - begin) / APART));
  }

  private static void add(List<Pose> poses, PlaneCurve curve, double u) {
    Vec2 at = curve.position(u);
    if (poses.isEmpty() || poses.getLast().position().distanceTo(at) > SAME) {
      poses.add(new Pose(at.x(), at.y(), curve.velocity(u).angle()));
    }
  }

  /** Metres. */
  public double length() {
    return passed[passed.length - 1];
  }

  /** The points that it is made of, metres, map frame. */
  public List<Vec2> points() {
    return poses.stream().map(Pose::position).toList();
  }

  /**
   * Where it is, and with which heading, after so many metres; before its start and behind its end,
   * there.
   */
  public Pose at(double metres) {
    int i = index(metres);
    if (i + 1 >= passed.length) {
      return poses.get(i);
    }
    Pose from = poses.get(i);
    Pose to = poses.get(i + 1);
    double share = Math.clamp((metres - passed[i]) / (passed[i + 1] - passed[i]), 0, 1);
    return new Pose(
        from.x() + share * (to.x() - from.x()),
        from.y() + share * (to.y() - from.y()),
        from.theta() + share * Angles.difference(from.theta(), to.theta()));
  }

  /** Radians a metre, positive to the left, after so many metres. */
  public double curvature(double metres) {
    int i = Math.min(index(metres), passed.length - 2);
    return i < 0
        ? 0
        : Angles.difference(poses.get(i).theta(), poses.get(i + 1).theta())
            / (passed[i + 1] - passed[i]);
  }

  /** Metres along it to the point that is nearest to another. */
  public double nearest(Vec2 point) {
    int nearest = 0;
    for (int i = 1; i < poses.size(); i++) {
      if (poses.get(i).position().distanceTo(point)
          < poses.get(nearest).position().distanceTo(point)) {
        nearest = i;
      }
    }
    return passed[nearest];
  }

  /** How far a point is from it, metres. */
  public double distanceTo(Vec2 point) {
    double nearest = poses.getFirst().position().distanceTo(point);
    for (int i = 1; i < poses.size(); i++) {
      nearest =
          Math.min(
              nearest, point.distanceToLine(poses.get(i - 1).position(), poses.get(i).position()));
    }
    return nearest;
  }

  /**
   * This line with another in place of a part of it.
   *
   * @param from metres along this one at which the other begins
   * @param to metres along this one at which the other ends
   */
  public DrivenLine withDetour(double from, double to, DrivenLine detour) {
    List<Pose> joined = new ArrayList<>(poses.subList(0, index(from) + 1));
    detour.poses.forEach(pose -> addApart(joined, pose));
    for (int i = index(to) + 1; i < poses.size(); i++) {
      addApart(joined, poses.get(i));
    }
    return new DrivenLine(joined);
  }

  private static void addApart(List<Pose> poses, Pose pose) {
    if (poses.getLast().distanceTo(pose) > SAME) {
      poses.add(pose);
    }
  }

  /** Of the last pose that is not beyond so many metres. */
  private int index(double metres) {
    int found = Arrays.binarySearch(passed, metres);
    return Math.clamp(found >= 0 ? found : -found - 2L, 0, passed.length - 1);
  }
}
