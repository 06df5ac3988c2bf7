package org.toqa.sim;

import java.util.List;
import java.util.Set;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Something solid on a floor, where it really is: a robot, or a load that several carry.
 *
 * @param core its middle for a disc, else its corners, counter-clockwise; metres, map frame
 * @param radius how far it reaches round its core, metres
 * @param carriers robots that may touch it, by name: they carry it
 */
public record Body(String name, List<Vec2> core, double radius, Set<String> carriers) {

  public Body {
    core = List.copyOf(core);
    carriers = Set.copyOf(carriers);
  }

  /**
   * A robot.
   *
   * @param centre metres, map frame
   * @param radius metres
   */
  public static Body disc(String name, Vec2 centre, double radius) {
    return new Body(name, List.of(centre), radius, Set.of());
  }

  /**
   * A rectangular load.
   *
   * @param middle of the load, x along its length, map frame
   * @param length metres
   * @param width metres
   * @param carriers the robots that carry it
   */
  public static Body load(
      String name, Pose middle, double length, double width, Set<String> carriers) {
    List<Vec2> corners =
        List.of(
            corner(middle, length / 2, width / 2),
            corner(middle, -length / 2, width / 2),
            corner(middle, -length / 2, -width / 2),
            corner(middle, length / 2, -width / 2));
    return new Body(name, corners, 0, carriers);
  }

  private static Vec2 corner(Pose middle, double x, double y) {
    return middle.compose(new Pose(x, y, 0)).position();
  }

  /** Whether the one carries the other, so that they may touch. */
  boolean isCarriedTogetherWith(Body other) {
    return carriers.contains(other.name) || other.carriers.contains(name);
  }

  /** Metres between the outlines; 0 or less where they touch. */
  public double gap(Body other) {
    return distance(core, other.core) - radius - other.radius;
  }

  /** Metres between the outline and a cell of the grid; 0 or less where they touch. */
  public double gap(OccupancyGrid grid, Cell cell) {
    Vec2 centre = grid.centre(cell);
    double half = grid.resolution() / 2;
    List<Vec2> square =
        List.of(
            centre.plus(new Vec2(half, half)),
            centre.plus(new Vec2(-half, half)),
            centre.plus(new Vec2(-half, -half)),
            centre.plus(new Vec2(half, -half)));
    return distance(core, square) - radius;
  }

  /** Metres between two points or convex outlines; 0 where they overlap. */
  private static double distance(List<Vec2> one, List<Vec2> other) {
    if (one.size() == 1 && other.size() == 1) {
      return one.getFirst().distanceTo(other.getFirst());
    }
    if (!hasSeparatingEdge(one, other) && !hasSeparatingEdge(other, one)) {
      return 0;
    }
    return Math.min(fromCornersToEdges(one, other), fromCornersToEdges(other, one));
  }

  /** Two convex outlines are apart exactly where all of one is beyond an edge of the other. */
  private static boolean hasSeparatingEdge(List<Vec2> outline, List<Vec2> other) {
    for (int i = 0; outline.size() > 1 && i < outline.size(); i++) {
      Vec2 from = outline.get(i);
      Vec2 edge = outline.get((i + 1) % outline.size()).minus(from);
      // edge x (p - from) < 0: p is to the right of the edge, so outside
      if (other.stream().allMatch(p -> cross(edge, p.minus(from)) < 0)) {
        return true;
      }
    }
    return false;
  }

  private static double cross(Vec2 a, Vec2 b) {
    return a.x() * b.y() - a.y() * b.x();
  }

  private static double fromCornersToEdges(List<Vec2> corners, List<Vec2> outline) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < outline.size(); i++) {
      Vec2 from = outline.get(i);
      Vec2 to = outline.get((i + 1) % outline.size());
      for (Vec2 corner : corners) {
        nearest = Math.min(nearest, corner.distanceToLine(from, to));
      }
    }
    return nearest;
  }
}
