package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;

/**
 * Robots that carry a load together, as one that drives: the leader, and with it the followers and
 * the load as discs in the leader's frame.
 */
public final class FormationFootprint {
  private final Shape shape;
  private final List<Part> parts = new ArrayList<>();

  /**
   * @param offset metres, in the leader's frame
   * @param radius metres
   */
  private record Part(Vec2 offset, double radius) {
    /** Where its middle is and how it moves while the leader does that. */
    SweptArea sweptArea(Pose leader, Segment segment) {
      Pose middle = leader.compose(new Pose(offset.x(), offset.y(), 0));
      if (segment.w() == 0) {
        return SweptArea.along(middle, segment, radius);
      }
      // every point of a rigid body goes round the same centre: v of the point is w x r
      Vec2 velocity = new Vec2(segment.v() - segment.w() * offset.y(), segment.w() * offset.x());
      Pose along = middle.compose(new Pose(0, 0, velocity.angle()));
      Segment own = new Segment(velocity.norm(), segment.w(), segment.t());
      return SweptArea.along(along, own, radius);
    }
  }

  /**
   * @param robotRadius of the largest robot, metres
   * @param length of the load, along the shape, metres
   * @param width of the load, metres
   */
  public FormationFootprint(Shape shape, double robotRadius, double length, double width) {
    this.shape = shape;
    parts.add(new Part(Vec2.ZERO, robotRadius));
    shape.offsets().forEach(offset -> parts.add(new Part(offset, robotRadius)));
    int pieces = (int) Math.ceil(length / width);
    double piece = length / pieces;
    for (int i = 0; i < pieces; i++) {
      Vec2 middle = new Vec2(-length / 2 + (i + 0.5) * piece, 0).minus(shape.leader());
      parts.add(new Part(middle, Math.hypot(piece, width) / 2));
    }
  }

  /** Where its discs are while the leader is at a pose, which may be told from any point. */
  static final class Placement {
    private final Pose leader;
    private final double[] middles; // x and y of each

    private Placement(Pose leader, double[] middles) {
      this.leader = leader;
      this.middles = middles;
    }

    Pose leader() {
      return leader;
    }
  }

  private FormationFootprint(Shape shape, List<Part> parts) {
    this.shape = shape;
    this.parts.addAll(parts);
  }

  /**
   * The same with larger robots and a larger load.
   *
   * @param metres more than their radii; below 0: less
   */
  FormationFootprint widened(double metres) {
    return new FormationFootprint(
        shape,
        parts.stream().map(part -> new Part(part.offset(), part.radius() + metres)).toList());
  }

  public Shape shape() {
    return shape;
  }

  /** Metres from the leader to the farthest point. */
  double radius() {
    return parts.stream().mapToDouble(p -> p.offset().norm() + p.radius()).max().orElseThrow();
  }

  /** Metres, from its rightmost to its leftmost point. */
  public double width() {
    double left = parts.stream().mapToDouble(p -> p.offset().y() + p.radius()).max().orElseThrow();
    double right = parts.stream().mapToDouble(p -> p.offset().y() - p.radius()).min().orElseThrow();
    return left - right;
  }

  /** Of the smallest of its discs, metres. */
  double smallestRadius() {
    return parts.stream().mapToDouble(Part::radius).min().orElseThrow();
  }

  /** Where its robots and its load are while it is stopped. */
  List<PlacedDisc> discs(Pose leader) {
    return parts.stream()
        .map(
            p ->
                new PlacedDisc(
                    leader.compose(new Pose(p.offset().x(), p.offset().y(), 0)).position(),
                    p.radius()))
        .toList();
  }

  /** What all of it covers while the leader drives the segment. */
  SweptArea sweptArea(Pose leader, Segment segment) {
    return SweptArea.union(parts.stream().map(p -> p.sweptArea(leader, segment)).toList());
  }

  /**
   * Whether all of it is off some cells, and on the grid.
   *
   * @param margin metres that it must keep besides
   */
  boolean isClearOf(OccupancyGrid grid, Pose leader, double margin, BitSet cells) {
    return isClearOf(grid, Vec2.ZERO, placement(leader), margin, cells);
  }

  /**
   * The same where it is placed beside a point.
   *
   * @param beside metres, map frame
   */
  boolean isClearOf(
      OccupancyGrid grid, Vec2 beside, Placement placement, double margin, BitSet cells) {
    for (int i = 0; i < parts.size(); i++) {
      double x = beside.x() + placement.middles[2 * i];
      double y = beside.y() + placement.middles[2 * i + 1];
      if (!isClearOf(grid, x, y, parts.get(i).radius() + margin, cells)) {
        return false;
      }
    }
    return true;
  }

  /** The formation as it is where its leader is at a pose. */
  Placement placement(Pose leader) {
    return new Placement(leader, middles(leader));
  }

  private double[] middles(Pose leader) {
    double cos = Math.cos(leader.theta());
    double sin = Math.sin(leader.theta());
    double[] middles = new double[2 * parts.size()];
    for (int i = 0; i < parts.size(); i++) {
      Vec2 offset = parts.get(i).offset();
      middles[2 * i] = leader.x() + offset.x() * cos - offset.y() * sin;
      middles[2 * i + 1] = leader.y() + offset.x() * sin + offset.y() * cos;
    }
    return middles;
  }

  private static boolean isClearOf(
      OccupancyGrid grid, double x, double y, double radius, BitSet cells) {
    double size = grid.resolution();
    double column = (x - grid.origin().x()) / size;
    double row = grid.height() - (y - grid.origin().y()) / size; // rows count southward
    double reach = radius / size;
    int firstColumn = (int) Math.floor(column - reach);
    int lastColumn = (int) Math.floor(column + reach);
    int firstRow = (int) Math.floor(row - reach);
    int lastRow = (int) Math.floor(row + reach);
    if (firstColumn < 0 || firstRow < 0 || lastColumn >= grid.width() || lastRow >= grid.height()) {
      return false;
    }
    for (int r = firstRow; r <= lastRow; r++) {
      double dy = Math.max(0, Math.max(r - row, row - r - 1));
      for (int c = firstColumn; c <= lastColumn; c++) {
        double dx = Math.max(0, Math.max(c - column, column - c - 1));
        if (dx * dx + dy * dy < reach * reach && cells.get(r * grid.width() + c)) {
          return false;
        }
      }
    }
    return true;
  }
}
