package org.toqa.planning.smooth.curve;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;
import org.toqa.planning.smooth.DiscSpace;

/**
 * Makes a curve of a free path of straight lines: a spline whose control points lie on the path,
 * close to each other at bends and far apart on long straight lines. Near walls they are moved a
 * little away from them, as a spline runs on the inner side of its control points.
 *
 * <p>The path is cut on its long lines into sections, which are fitted one by one: on these lines
 * the spline is straight whatever comes before and after. Where a section's curve would touch a
 * wall, it is made again with more points that are moved less: the closer they are, the closer is
 * the curve to the path, which is free. Where even the closest touches, as in a bend that just
 * fits, each half of the section becomes a curve of its own, and so on down to a single line;
 * between two, the robot turns on the spot.
 */
public final class SplineFitter {
  /** Control points in a radius of the disc, and by which share of it they keep off walls. */
  private static final double[][] TRIES = {
    {4, 0.006}, {6, 0.004}, {8, 0.002}, {8, 0}, {16, 0}, {32, 0}, {64, 0}
  };

  /** Radii of the disc: so much of a long line belongs to the sections on both sides of it. */
  private static final double STRAIGHT_OF_SECTION = 0.6;

  /** Radii of the disc: lines that are longer than this are cut. */
  private static final double LONG_LINE = 1.4;

  /** Radii of the disc between control points on long lines. */
  private static final double FARTHEST = 2;

  /** Control points at each end of a section that stay on the path. */
  private static final int STAY = 3;

  /** No section has more control points. */
  private static final int MOST_POINTS = 200_000;

  /** A heading that is farther from the path's direction needs a turn on the spot, radians. */
  private static final double LARGEST_TURN = Math.PI / 2;

  private final DiscSpace space;
  private final CurveChecker checker;

  /**
   * @param space of the disc that shall drive the curve
   */
  public SplineFitter(DiscSpace space) {
    this.space = space;
    this.checker = new CurveChecker(space);
  }

  /** A free curve for a free path, metres, map frame; with any heading at its ends. */
  public SmoothCurve fit(List<Vec2> path) {
    return fit(path, null, null);
  }

  /**
   * The same with headings at its ends. One that the curve cannot have, for want of room or since
   * it is more than 90 degrees off, is left out: there the robot turns on the spot.
   *
   * @param start radians, counter-clockwise from map east; null for any
   * @param goal the same where it ends
   */
  public SmoothCurve fit(List<Vec2> path, @Nullable Double start, @Nullable Double goal) {
    List<Vec2> points = withoutRepeats(path);
    List<CubicSpline> pieces = new ArrayList<>();
    if (points.size() > 1) {
      pieces.addAll(pieces(points));
      if (start != null) {
        pieces.set(0, withHeading(pieces.getFirst(), start));
      }
      if (goal != null) {
        CubicSpline back = withHeading(pieces.getLast().reversed(), goal + Math.PI);
        pieces.set(pieces.size() - 1, back.reversed());
      }
    }
    return new SmoothCurve(pieces);
  }

  private static List<Vec2> withoutRepeats(List<Vec2> path) {
    List<Vec2> points = new ArrayList<>();
    for (Vec2 point : path) {
      if (points.isEmpty() || !points.getLast().equals(point)) {
        points.add(point);
      }
    }
    return points;
  }

  /** Splines along a path that follow each other; one, if no section needs more. */
  private List<CubicSpline> pieces(List<Vec2> path) {
    List<CubicSpline> pieces = new ArrayList<>();
    List<Vec2> controls = new ArrayList<>();
    for (List<Vec2> section : sections(path)) {
      List<List<Vec2>> fitted = new ArrayList<>();
      addControls(fitted, section);
      if (!controls.isEmpty()) {
        addStraight(controls, fitted.getFirst());
      }
      controls.addAll(fitted.getFirst());
      for (List<Vec2> next : fitted.subList(1, fitted.size())) {
        pieces.add(CubicSpline.through(controls));
        controls = new ArrayList<>(next);
      }
    }
    pieces.add(CubicSpline.through(controls));
    return pieces;
  }

  /** The path without the middles of its long lines. */
  private List<List<Vec2>> sections(List<Vec2> path) {
    List<List<Vec2>> sections = new ArrayList<>();
    List<Vec2> section = new ArrayList<>(path.subList(0, 1));
    for (int i = 1; i < path.size(); i++) {
      Vec2 from = path.get(i - 1);
      Vec2 to = path.get(i);
      double length = from.distanceTo(to);
      if (length > LONG_LINE * space.radius()) {
        Vec2 ends = to.minus(from).times(STRAIGHT_OF_SECTION * space.radius() / length);
        section.add(from.plus(ends));
        sections.add(section);
        section = new ArrayList<>(List.of(to.minus(ends)));
      }
      section.add(to);
    }
    sections.add(section);
    return sections;
  }

  /** Control points from the end of a section to the next one, first ever farther apart. */
  private void addStraight(List<Vec2> controls, List<Vec2> next) {
    Vec2 from = controls.getLast();
    Vec2 to = next.getFirst();
    double length = from.distanceTo(to);
    double most = FARTHEST * space.radius();
    double step = from.distanceTo(controls.get(controls.size() - 2));
    double lastStep = to.distanceTo(next.get(1));
    step = Math.min(most, 2 * step);
    double at = step;
    while (at < length - lastStep) {
      controls.add(from.plus(to.minus(from).times(at / length)));
      step = Math.min(most, Math.min(2 * step, Math.max(lastStep, (length - at) / 2)));
      at += step;
    }
  }

  /** One spline's control points for all of a section, or those for each half, and so on. */
  private void addControls(List<List<Vec2>> pieces, List<Vec2> section) {
    List<Vec2> whole = section.size() == 2 ? straight(section) : freeControls(section);
    if (whole != null) {
      pieces.add(whole);
      return;
    }
    int middle = section.size() / 2;
    addControls(pieces, section.subList(0, middle + 1));
    addControls(pieces, section.subList(middle, section.size()));
  }

  private @Nullable List<Vec2> freeControls(List<Vec2> section) {
    double length = Vec2.lengthOf(section);
    for (double[] attempt : TRIES) {
      double apart = space.radius() / attempt[0];
      if (length / apart > MOST_POINTS) {
        return null;
      }
      List<Vec2> controls = along(section, Math.min(apart, length / 4));
      keepOffWalls(controls, attempt[1] * space.radius());
      if (checker.isFree(CubicSpline.through(controls))) {
        return controls;
      }
    }
    return null;
  }

  /** With a few control points more, so that it can turn into a heading at an end. */
  private List<Vec2> straight(List<Vec2> line) {
    return along(line, Math.min(space.radius() / TRIES[0][0], Vec2.lengthOf(line) / 4));
  }

  /**
   * Points along a path: its bends, but those too close to the one before, and points between.
   *
   * @param apart metres that neighbours are apart at most, and half of which bends are at least
   */
  private static List<Vec2> along(List<Vec2> path, double apart) {
    List<Vec2> points = new ArrayList<>();
    points.add(path.getFirst());
    double[] passed = new double[path.size()];
    for (int i = 1; i < passed.length; i++) {
      passed[i] = passed[i - 1] + path.get(i - 1).distanceTo(path.get(i));
    }
    int last = passed.length - 1;
    int from = 0;
    for (int to = 1; to <= last; to++) {
      boolean isKept =
          passed[to] - passed[from] >= apart / 2 && passed[last] - passed[to] >= apart / 2;
      if (isKept || to == last) {
        addBetween(points, path, passed, from, to, apart);
        from = to;
      }
    }
    return points;
  }

  /** Adds points at equal distances from one bend to another, and the latter. */
  private static void addBetween(
      List<Vec2> points, List<Vec2> path, double[] passed, int from, int to, double apart) {
    double length = passed[to] - passed[from];
    int steps = (int) Math.max(1, Math.ceil(length / apart - 1e-6));
    int leg = from + 1;
    for (int i = 1; i < steps; i++) {
      double at = passed[from] + length * i / steps;
      while (passed[leg] < at) {
        leg++;
      }
      double share = (at - passed[leg - 1]) / (passed[leg] - passed[leg - 1]);
      points.add(path.get(leg - 1).plus(path.get(leg).minus(path.get(leg - 1)).times(share)));
    }
    points.add(path.get(to));
  }

  private void keepOffWalls(List<Vec2> controls, double margin) {
    if (margin > 0) {
      for (int i = STAY; i < controls.size() - STAY; i++) {
        controls.set(i, space.awayFromWalls(controls.get(i), margin));
      }
    }
  }

  /** Begins in a direction, if there is room; else as it was. */
  private CubicSpline withHeading(CubicSpline spline, double heading) {
    Vec2 start = spline.position(0);
    Vec2 velocity = spline.velocity(0);
    if (Math.abs(Angles.difference(velocity.angle(), heading)) > LARGEST_TURN) {
      return spline;
    }
    // P(-1) + 4 P(0) + P(1) = 6 start and P(1) - P(-1) = 2 velocity, with P(1) as it is
    Vec2 third = spline.controls().get(2);
    Vec2 along = new Vec2(velocity.norm(), 0).rotated(heading);
    List<Vec2> controls = new ArrayList<>(spline.controls());
    controls.set(0, third.minus(along.times(2)));
    controls.set(1, start.times(6).minus(third.times(2)).plus(along.times(2)).times(0.25));
    CubicSpline turned = new CubicSpline(controls);
    return checker.isFree(turned) ? turned : spline;
  }
}
