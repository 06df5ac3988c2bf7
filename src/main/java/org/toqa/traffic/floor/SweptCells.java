package org.toqa.traffic.floor;

import java.util.List;
import java.util.stream.IntStream;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;

/**
 * The cells that a disc touches while it is driven: exact for straights, never too few for arcs.
 */
final class SweptCells {
  /** An arc is taken as chords; so far, in metres, it may rise over its chord. */
  private static final double MAX_CHORD_HEIGHT = 0.0005;

  private SweptCells() {}

  /**
   * The cells under a disc at rest; parts outside the grid are left out.
   *
   * @param radius metres
   */
  static CellSet at(OccupancyGrid grid, Vec2 centre, double radius) {
    return CellSet.of(indices(grid, new Disc(radius).cellsAt(grid, centre)).toArray());
  }

  /** The cells that the disc touches on a straight line. */
  static CellSet alongLine(OccupancyGrid grid, Vec2 from, Vec2 to, double radius) {
    return CellSet.of(indices(grid, new Disc(radius).cellsAlong(grid, from, to)).toArray());
  }

  /** The cells that the disc touches while it drives the segment. */
  static CellSet alongSegment(OccupancyGrid grid, Pose from, Segment segment, double radius) {
    double angle = Math.abs(segment.angle());
    boolean isArc = segment.v() != 0 && angle != 0;
    double arcRadius = isArc ? Math.abs(segment.length()) / angle : 0;
    int chords = isArc ? chords(arcRadius, angle) : 1;
    // height of an arc over its chord: R (1 - cos(angle/2))
    double height = arcRadius * (1 - Math.cos(angle / chords / 2));
    Disc disc = new Disc(radius + height);
    IntStream touched = IntStream.empty();
    Pose pose = from;
    for (int i = 0; i < chords; i++) {
      Pose next = pose.advanced(segment.twist(), segment.t() / chords);
      touched =
          IntStream.concat(
              touched, indices(grid, disc.cellsAlong(grid, pose.position(), next.position())));
      pose = next;
    }
    return CellSet.of(touched.toArray());
  }

  private static int chords(double radius, double angle) {
    double chordAngle = 2 * Math.acos(Math.max(0, 1 - MAX_CHORD_HEIGHT / radius));
    return Math.max(1, (int) Math.ceil(angle / chordAngle));
  }

  private static IntStream indices(OccupancyGrid grid, List<Cell> cells) {
    return cells.stream().mapToInt(grid::index);
  }
}
