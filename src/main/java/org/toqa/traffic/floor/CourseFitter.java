package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;

/**
 * Makes stretches of a way over cells: fits the segments, cuts the straights in the middle of every
 * cell, and gathers what lies between two such places.
 */
final class CourseFitter {
  /** How near to a cell's middle, in cells, a robot counts as standing in it. */
  private static final double MIDDLE = 0.2;

  private static final double SHORTEST = 1e-6;

  private final OccupancyGrid grid;
  private final SegmentFitter fitter;

  CourseFitter(OccupancyGrid grid, DriveSpeeds speeds) {
    this.grid = grid;
    this.fitter = new SegmentFitter(speeds, grid.resolution());
  }

  /**
   * @param start where the robot stands, about in the middle of a cell
   * @param radius of the robot, metres
   */
  List<Stretch> fit(Pose start, List<Waypoint> way, double radius) {
    List<Stretch> stretches = new ArrayList<>();
    List<Segment> gathered = new ArrayList<>();
    BitSet cells = new BitSet();
    Pose pose = start;
    for (Segment whole : fitter.fit(start, way).segments()) {
      for (Segment piece : cut(pose, whole)) {
        gathered.add(piece);
        cells.or(SweptCells.of(grid, pose, piece, radius));
        pose = pose.advanced(piece.twist(), piece.t());
        if (isInTheMiddle(pose.position())) {
          BitSet endCells = SweptCells.standing(grid, pose.position(), radius);
          stretches.add(new Stretch(gathered, pose, cells, endCells));
          gathered = new ArrayList<>();
          cells = new BitSet();
        }
      }
    }
    if (!gathered.isEmpty()) {
      BitSet endCells = SweptCells.standing(grid, pose.position(), radius);
      stretches.add(new Stretch(gathered, pose, cells, endCells));
    }
    return stretches;
  }

  private boolean isInTheMiddle(Vec2 point) {
    return point.distanceTo(grid.centre(grid.cellAt(point))) < MIDDLE * grid.resolution();
  }

  /** A straight in pieces that end where it passes the middles of cells; anything else whole. */
  private List<Segment> cut(Pose from, Segment segment) {
    if (segment.w() != 0 || segment.v() == 0) {
      return List.of(segment);
    }
    Vec2 forward = new Vec2(1, 0).rotated(from.theta());
    List<Segment> pieces = new ArrayList<>();
    double covered = 0;
    for (double along : middles(from.position(), forward, segment.length())) {
      pieces.add(new Segment(segment.v(), 0, (along - covered) / segment.v()));
      covered = along;
    }
    if (segment.length() - covered > SHORTEST) {
      pieces.add(new Segment(segment.v(), 0, (segment.length() - covered) / segment.v()));
    }
    return pieces;
  }

  /** How far along a straight it passes the middles of cells, ends left out. */
  private List<Double> middles(Vec2 from, Vec2 forward, double length) {
    List<Double> found = new ArrayList<>();
    double step = grid.resolution() / 2;
    Cell last = null;
    for (double s = 0; s <= length; s += step) {
      Cell cell = grid.cellAt(from.plus(forward.times(s)));
      if (cell.equals(last)) {
        continue;
      }
      last = cell;
      Vec2 toMiddle = grid.centre(cell).minus(from);
      double along = toMiddle.x() * forward.x() + toMiddle.y() * forward.y();
      double beside = Math.abs(toMiddle.y() * forward.x() - toMiddle.x() * forward.y());
      boolean isInside = along > MIDDLE * step && along < length - MIDDLE * step;
      if (beside < MIDDLE * grid.resolution() && isInside) {
        found.add(along);
      }
    }
    return found;
  }
}
