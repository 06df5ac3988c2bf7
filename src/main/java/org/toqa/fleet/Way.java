package org.toqa.fleet;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.SweptCells;

/**
 * A drive and the cells that it needs.
 *
 * @param sweeps by segment: the cells that the robot's disc touches while it drives it, as bits by
 *     {@link OccupancyGrid#index}
 */
record Way(StoredDrive drive, List<BitSet> sweeps) {

  Way {
    sweeps = List.copyOf(sweeps);
  }

  /**
   * @param footprint the robot's diameter, metres
   */
  static Way of(StoredDrive drive, OccupancyGrid grid, double footprint) {
    return new Way(drive, SweptCells.bySegment(grid, drive.way(), footprint / 2));
  }

  /** The cells of the segments from {@code segment} on. */
  BitSet cellsFrom(int segment) {
    BitSet cells = new BitSet();
    sweeps.subList(Math.min(segment, sweeps.size()), sweeps.size()).forEach(cells::or);
    return cells;
  }

  /** The way from {@code segment} on as the points of a line; arcs get points in between. */
  List<Vec2> pointsFrom(int segment) {
    Trajectory way = drive.way();
    List<Vec2> points = new ArrayList<>();
    Pose pose = way.start();
    for (int i = 0; i < way.segments().size(); i++) {
      Segment s = way.segments().get(i);
      if (i >= segment && s.v() != 0) {
        int pieces = Math.max(1, (int) Math.ceil(Math.abs(s.angle()) / 0.3));
        for (int k = 1; k <= pieces; k++) {
          points.add(pose.advanced(s.twist(), s.t() * k / pieces).position());
        }
      }
      pose = pose.advanced(s.twist(), s.t());
    }
    return points;
  }
}
