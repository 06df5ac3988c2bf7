package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * The cells that a disc touches while it is driven: exact for straights, never too few for arcs.
 */
final class SweptCells {
  /** An arc is taken as chords of at most this angle, radians. */
  private static final double CHORD = 0.1;

  private SweptCells() {}

  /**
   * The cells under a standing disc, as bits by {@link OccupancyGrid#index}; parts outside the grid
   * are left out.
   *
   * @param radius metres
   */
  static BitSet standing(OccupancyGrid grid, Vec2 centre, double radius) {
    BitSet cells = new BitSet();
    new Disc(radius).cellsAt(grid, centre).forEach(c -> cells.set(grid.index(c)));
    return cells;
  }

  /**
   * By segment of the trajectory, the cells that the disc touches while it is driven.
   *
   * @param radius metres
   */
  static List<BitSet> bySegment(OccupancyGrid grid, Trajectory way, double radius) {
    List<BitSet> sweeps = new ArrayList<>();
    Pose pose = way.start();
    for (Segment segment : way.segments()) {
      sweeps.add(of(grid, pose, segment, radius));
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return sweeps;
  }

  static BitSet of(OccupancyGrid grid, Pose from, Segment segment, double radius) {
    int chords =
        segment.v() == 0 ? 1 : Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / CHORD));
    double chordAngle = segment.angle() / chords;
    // height of an arc over its chord: R (1 - cos(angle/2)), with R = length / angle
    double height =
        segment.angle() == 0
            ? 0
            : segment.length() / Math.abs(segment.angle()) * (1 - Math.cos(chordAngle / 2));
    Disc disc = new Disc(radius + height);
    BitSet cells = new BitSet();
    Pose pose = from;
    for (int i = 0; i < chords; i++) {
      Pose next = pose.advanced(segment.twist(), segment.t() / chords);
      disc.cellsAlong(grid, pose.position(), next.position())
          .forEach(c -> cells.set(grid.index(c)));
      pose = next;
    }
    return cells;
  }
}
