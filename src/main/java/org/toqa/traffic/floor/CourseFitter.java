package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;

/**
 * Makes stretches of a way: fits the segments, cuts the straights where the robot may stand, and
 * gathers what lies between two such places.
 */
final class CourseFitter {
  private static final double SHORTEST = 1e-6;

  private final OccupancyGrid grid;

  /**
   * @param grid whose cells the stretches list
   */
  CourseFitter(OccupancyGrid grid) {
    this.grid = grid;
  }

  /**
   * @param start where the robot stands
   * @param cornerLength metres, of {@link SegmentFitter}
   */
  List<Stretch> fit(Mover mover, Pose start, List<Waypoint> way, double cornerLength, Halts halts) {
    List<Stretch> stretches = new ArrayList<>();
    Gathered gathered = new Gathered();
    Pose pose = start;
    for (Segment whole : new SegmentFitter(mover.speeds, cornerLength).fit(start, way).segments()) {
      for (Segment piece : cut(pose, whole, halts)) {
        gathered.add(piece, SweptCells.of(grid, pose, piece, mover.radius));
        pose = pose.advanced(piece.twist(), piece.t());
        if (halts.isHalt(pose.position(), gathered.length)) {
          stretches.add(gathered.until(pose, mover.radius));
          gathered = new Gathered();
        }
      }
    }
    if (!gathered.segments.isEmpty()) {
      stretches.add(gathered.until(pose, mover.radius));
    }
    return stretches;
  }

  /** What belongs to the next stretch. */
  private final class Gathered {
    final List<Segment> segments = new ArrayList<>();
    CellSet cells = CellSet.NONE;
    double length;

    void add(Segment piece, CellSet swept) {
      segments.add(piece);
      cells = cells.and(swept);
      length += piece.length();
    }

    Stretch until(Pose end, double radius) {
      return new Stretch(segments, end, cells, SweptCells.standing(grid, end.position(), radius));
    }
  }

  /** A straight in pieces that end where the robot may stand; anything else whole. */
  private static List<Segment> cut(Pose from, Segment segment, Halts halts) {
    if (segment.w() != 0 || segment.v() == 0) {
      return List.of(segment);
    }
    Vec2 forward = new Vec2(1, 0).rotated(from.theta());
    List<Segment> pieces = new ArrayList<>();
    double covered = 0;
    for (double along : halts.along(from.position(), forward, segment.length())) {
      pieces.add(new Segment(segment.v(), 0, (along - covered) / segment.v()));
      covered = along;
    }
    if (segment.length() - covered > SHORTEST) {
      pieces.add(new Segment(segment.v(), 0, (segment.length() - covered) / segment.v()));
    }
    return pieces;
  }
}
