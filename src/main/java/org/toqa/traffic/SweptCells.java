package org.toqa.traffic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * The cells that a disc touches: where it stands, and while it is driven.
 *
 * <p>A motion is sampled, and the disc grown by what can lie between two samples, so that no cell is
 * ever missed; a cell that is passed at less than {@link #SAMPLE} may be counted though it is not
 * touched.
 */
public final class SweptCells {
  /** Metres between two samples of a motion. */
  private static final double SAMPLE = 0.01;

  private SweptCells() {}

  /**
   * The cells under a standing disc, as bits by {@link OccupancyGrid#index}; parts outside the grid
   * are left out.
   *
   * @param radius metres
   */
  public static BitSet standing(OccupancyGrid grid, Vec2 centre, double radius) {
    BitSet cells = new BitSet();
    addDisc(cells, grid, centre, radius);
    return cells;
  }

  /**
   * By segment of the trajectory, the cells that the disc touches while it is driven.
   *
   * @param radius metres
   */
  public static List<BitSet> bySegment(OccupancyGrid grid, Trajectory way, double radius) {
    List<BitSet> sweeps = new ArrayList<>();
    Pose pose = way.start();
    for (Segment segment : way.segments()) {
      BitSet cells = new BitSet();
      int samples = Math.max(1, (int) Math.ceil(segment.length() / SAMPLE));
      for (int i = 0; i <= samples; i++) {
        Pose sample = pose.advanced(segment.twist(), segment.t() * i / samples);
        // between two samples the centre strays from the nearer one by at most half their distance
        addDisc(cells, grid, sample.position(), radius + (segment.v() == 0 ? 0 : SAMPLE / 2));
      }
      sweeps.add(cells);
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return sweeps;
  }

  private static void addDisc(BitSet cells, OccupancyGrid grid, Vec2 centre, double radius) {
    double k = grid.resolution();
    Cell low = grid.cellAt(centre.minus(new Vec2(radius, radius)));
    Cell high = grid.cellAt(centre.plus(new Vec2(radius, radius)));
    for (int row = Math.max(0, high.row()); row <= Math.min(grid.height() - 1, low.row()); row++) {
      for (int column = Math.max(0, low.column());
          column <= Math.min(grid.width() - 1, high.column());
          column++) {
        Vec2 middle = grid.centre(new Cell(column, row));
        // distance from the disc's centre to the cell's square
        double dx = Math.max(0, Math.abs(centre.x() - middle.x()) - k / 2);
        double dy = Math.max(0, Math.abs(centre.y() - middle.y()) - k / 2);
        if (Math.hypot(dx, dy) < radius) {
          cells.set(row * grid.width() + column);
        }
      }
    }
  }
}
