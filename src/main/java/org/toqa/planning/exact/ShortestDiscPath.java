package org.toqa.planning.exact;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/**
 * The exact length of the shortest path of a disc among the occupied squares of a grid, the outside
 * of the grid being wall: the visibility graph of the corners grown to arcs (Liu and Arimoto, "Path
 * planning using a tangent graph", 1992). A shortest path consists of lines that are tangent to two
 * arcs, or end at start or goal, and of the arcs between; it turns about each corner in one sense.
 *
 * <p>The graph is searched by A* (Hart, Nilsson and Raphael, 1968) with the straight distance, and
 * the tangents of a corner are made when it is first reached. Cost: for each corner that is
 * reached, all others.
 */
public final class ShortestDiscPath {
  /** Radians. */
  private static final double ANGLE_TOLERANCE = 1e-9;

  /** Cells by which a longer way to the same place is no other way. */
  private static final double COST_TOLERANCE = 1e-10;

  private final OccupancyGrid grid;
  private final double radius;
  private final WallRuns walls;
  private final List<Corner> corners;
  private final double[] xs;
  private final double[] ys;

  /** By corner: the free parts of its arc, once they were asked for. */
  private final double[][] parts;

  /** By corner and sense: the tangents that leave it. */
  private final List<@Nullable List<Tangent>> tangents = new ArrayList<>();

  /**
   * A line that leaves an arc and is tangent to another one.
   *
   * @param depart angle driven about the first corner, from the first point of its quarter in the
   *     sense of turning, to where the line begins
   * @param arc corner and sense of the other one, see {@link #arc}
   * @param arrive the same angle about the other corner, where the line ends
   * @param length cells
   */
  private record Tangent(double depart, int arc, double arrive, double length) {}

  /**
   * A way to a point of an arc.
   *
   * @param angle as of {@link Tangent#arrive}
   * @param end of the free part that the point is on, the same angle
   * @param cost cells driven
   * @param estimate cells driven and the straight distance to the goal
   */
  private record Label(int arc, double angle, double end, double cost, double estimate) {}

  /**
   * Lays a grid out.
   *
   * @param radius of the disc, metres, above 0
   */
  public ShortestDiscPath(OccupancyGrid grid, double radius) {
    this.grid = grid;
    this.radius = radius / grid.resolution();
    this.walls = new WallRuns(grid, this.radius);
    this.corners = Corner.of(walls);
    this.xs = corners.stream().mapToDouble(Corner::x).toArray();
    this.ys = corners.stream().mapToDouble(Corner::y).toArray();
    this.parts = new double[corners.size()][];
    for (int i = 0; i < 2 * corners.size(); i++) {
      tangents.add(null);
    }
  }

  /**
   * Its length, metres; nothing where there is no path.
   *
   * @param from metres, map frame
   * @param to metres, map frame
   */
  public OptionalDouble length(Vec2 from, Vec2 to) {
    Vec2 start = from.minus(grid.origin()).times(1 / grid.resolution());
    Vec2 goal = to.minus(grid.origin()).times(1 / grid.resolution());
    if (!walls.isFree(start.x(), start.y()) || !walls.isFree(goal.x(), goal.y())) {
      return OptionalDouble.empty();
    }
    if (walls.isFree(start.x(), start.y(), goal.x(), goal.y())) {
      return OptionalDouble.of(from.distanceTo(to));
    }
    double cells = new Search(start, goal).run();
    return cells == Double.POSITIVE_INFINITY
        ? OptionalDouble.empty()
        : OptionalDouble.of(cells * grid.resolution());
  }

  /** The number of a corner's arc; counter-clockwise ones are even. */
  private static int arc(int corner, boolean clockwise) {
    return 2 * corner + (clockwise ? 1 : 0);
  }

  private static boolean isClockwise(int arc) {
    return (arc & 1) == 1;
  }

  /** The angle driven about a corner to a direction, seen from the corner; may lie off the arc. */
  private double driven(int arc, double direction) {
    double angle = corners.get(arc / 2).fromBegin(direction);
    return isClockwise(arc) ? Corner.QUARTER - angle : angle;
  }

  private static boolean isOnArc(double driven) {
    return driven >= -ANGLE_TOLERANCE && driven <= Corner.QUARTER + ANGLE_TOLERANCE;
  }

  /** The point of an arc after an angle. */
  private Vec2 point(int arc, double driven) {
    Corner corner = corners.get(arc / 2);
    double angle = corner.begin() + (isClockwise(arc) ? Corner.QUARTER - driven : driven);
    return new Vec2(corner.x() + radius * Math.cos(angle), corner.y() + radius * Math.sin(angle));
  }

  /** The end of the free part of an arc that an angle is on; below it where it is on none. */
  private double endOfPart(int arc, double driven) {
    double[] free = parts[arc / 2];
    if (free == null) {
      free = corners.get(arc / 2).freeParts(walls, radius);
      parts[arc / 2] = free;
    }
    for (int i = 0; i < free.length; i += 2) {
      double begin = isClockwise(arc) ? Corner.QUARTER - free[i + 1] : free[i];
      double end = isClockwise(arc) ? Corner.QUARTER - free[i] : free[i + 1];
      if (driven >= begin - ANGLE_TOLERANCE && driven <= end + ANGLE_TOLERANCE) {
        return end;
      }
    }
    return Double.NEGATIVE_INFINITY;
  }

  private List<Tangent> tangentsOf(int arc) {
    List<Tangent> known = tangents.get(arc);
    if (known == null) {
      known = new ArrayList<>();
      for (int other = 0; other < corners.size(); other++) {
        addTangents(known, arc, other);
      }
      tangents.set(arc, known);
    }
    return known;
  }

  private void addTangents(List<Tangent> known, int arc, int other) {
    int corner = arc / 2;
    double alongX = xs[other] - xs[corner];
    double alongY = ys[other] - ys[corner];
    double distance = Math.sqrt(alongX * alongX + alongY * alongY);
    if (distance == 0) {
      return;
    }
    double direction = Math.atan2(alongY, alongX);
    boolean clockwise = isClockwise(arc);
    double aside = clockwise ? 1 : -1;
    // the outer tangent: both touch at a right angle to the line between the corners
    double outer = direction + aside * Corner.QUARTER;
    addTangent(known, arc, outer, arc(other, clockwise), outer);
    // the inner one: cos(angle to that line) = 2 r / distance
    double cos = 2 * radius / distance;
    if (cos <= 1 + ANGLE_TOLERANCE) {
      double inner = direction + aside * Math.acos(Math.min(1, cos));
      addTangent(known, arc, inner, arc(other, !clockwise), inner + Math.PI);
    }
  }

  private void addTangent(
      List<Tangent> known, int arc, double fromDirection, int other, double toDirection) {
    double depart = driven(arc, fromDirection);
    if (!isOnArc(depart)) {
      return;
    }
    double arrive = driven(other, toDirection);
    if (!isOnArc(arrive)) {
      return;
    }
    Vec2 from = point(arc, depart);
    Vec2 to = point(other, arrive);
    if (walls.isFree(from.x(), from.y(), to.x(), to.y())) {
      known.add(new Tangent(depart, other, arrive, from.distanceTo(to)));
    }
  }

  /** One search. */
  private final class Search {
    private final Vec2 start;
    private final Vec2 goal;
    private final PriorityQueue<Label> open =
        new PriorityQueue<>((a, b) -> Double.compare(a.estimate(), b.estimate()));
    private final List<@Nullable List<Label>> labels = new ArrayList<>();
    private double shortest = Double.POSITIVE_INFINITY;

    Search(Vec2 start, Vec2 goal) {
      this.start = start;
      this.goal = goal;
      for (int i = 0; i < 2 * corners.size(); i++) {
        labels.add(null);
      }
    }

    double run() {
      for (int arc = 0; arc < 2 * corners.size(); arc++) {
        addFromStart(arc);
      }
      while (!open.isEmpty()) {
        Label label = open.remove();
        if (label.estimate() >= shortest) {
          break;
        }
        toGoal(label);
        for (Tangent tangent : tangentsOf(label.arc())) {
          follow(label, tangent);
        }
      }
      return shortest;
    }

    private void addFromStart(int arc) {
      double driven = touch(arc, start, isClockwise(arc) ? -1 : 1);
      if (isOnArc(driven)) {
        Vec2 point = point(arc, driven);
        if (walls.isFree(start.x(), start.y(), point.x(), point.y())) {
          add(arc, driven, start.distanceTo(point));
        }
      }
    }

    /**
     * Where a line from or to a point touches an arc; NaN where the point is inside the circle.
     *
     * @param sign 1 or -1: on which side
     */
    private double touch(int arc, Vec2 point, int sign) {
      Vec2 away = point.minus(new Vec2(xs[arc / 2], ys[arc / 2]));
      double cos = radius / away.norm();
      return cos > 1 + ANGLE_TOLERANCE
          ? Double.NaN
          : driven(arc, away.angle() + sign * Math.acos(Math.min(1, cos)));
    }

    private void toGoal(Label label) {
      double depart = touch(label.arc(), goal, isClockwise(label.arc()) ? 1 : -1);
      if (isOnArc(depart) && canDrive(label, depart)) {
        Vec2 point = point(label.arc(), depart);
        if (walls.isFree(point.x(), point.y(), goal.x(), goal.y())) {
          shortest = Math.min(shortest, costAt(label, depart) + point.distanceTo(goal));
        }
      }
    }

    private void follow(Label label, Tangent tangent) {
      if (canDrive(label, tangent.depart())) {
        double cost = costAt(label, tangent.depart()) + tangent.length();
        add(tangent.arc(), tangent.arrive(), cost);
      }
    }

    private static boolean canDrive(Label label, double depart) {
      return depart >= label.angle() - ANGLE_TOLERANCE && depart <= label.end() + ANGLE_TOLERANCE;
    }

    private double costAt(Label label, double depart) {
      return label.cost() + radius * Math.max(0, depart - label.angle());
    }

    private void add(int arc, double angle, double cost) {
      double end = endOfPart(arc, angle);
      List<Label> known = labels.get(arc);
      if (known == null) {
        known = new ArrayList<>();
        labels.set(arc, known);
      }
      if (end < angle - ANGLE_TOLERANCE || isKnown(known, angle, end, cost)) {
        return;
      }
      Label label = new Label(arc, angle, end, cost, cost + point(arc, angle).distanceTo(goal));
      known.add(label);
      open.add(label);
    }

    /** Whether a known way to an earlier point of the same part is not longer. */
    private boolean isKnown(List<Label> known, double angle, double end, double cost) {
      for (Label label : known) {
        if (label.end() == end
            && label.angle() <= angle + ANGLE_TOLERANCE
            && costAt(label, angle) <= cost + COST_TOLERANCE) {
          return true;
        }
      }
      return false;
    }
  }
}
