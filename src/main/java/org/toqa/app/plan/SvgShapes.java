package org.toqa.app.plan;

import static org.toqa.svg.SvgWriter.number;

import java.util.BitSet;
import java.util.Collection;
import java.util.stream.Collectors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * Outlines in the language of SVG paths: one unit is a cell, (0, 0) the map's upper left corner.
 */
record SvgShapes(OccupancyGrid grid) {

  /** A point of the map frame, metres, in units of the picture. */
  Vec2 toPicture(Vec2 point) {
    Vec2 cells = point.minus(grid.origin()).times(1 / grid.resolution());
    return new Vec2(cells.x(), grid.height() - cells.y());
  }

  /**
   * An area of cells, given by {@link OccupancyGrid#index}, as rectangles of neighbours in a row.
   */
  String cellArea(BitSet cells) {
    StringBuilder path = new StringBuilder();
    int from = cells.nextSetBit(0);
    while (from >= 0) {
      Cell first = grid.cell(from);
      int endOfRow = (first.row() + 1) * grid.width();
      int to = Math.min(cells.nextClearBit(from), endOfRow);
      int length = to - from;
      path.append("M" + first.column() + " " + first.row() + "h" + length + "v1h-" + length + "z");
      from = cells.nextSetBit(to);
    }
    return path.toString();
  }

  /** The lines between the cells. */
  String gridLines() {
    StringBuilder path = new StringBuilder();
    for (int column = 1; column < grid.width(); column++) {
      path.append("M").append(column).append(" 0v").append(grid.height());
    }
    for (int row = 1; row < grid.height(); row++) {
      path.append("M0 ").append(row).append("h").append(grid.width());
    }
    return path.toString();
  }

  /** A line through the middles of cells. */
  String polyline(Collection<Cell> cells) {
    return cells.stream()
        .map(grid::centre)
        .map(centre -> point(toPicture(centre)))
        .collect(Collectors.joining("L", "M", ""));
  }

  /** Straights and arcs as they are driven. */
  String trajectoryPath(Trajectory trajectory) {
    StringBuilder path = new StringBuilder("M" + point(toPicture(trajectory.start().position())));
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      pose = pose.advanced(segment.twist(), segment.t());
      String end = point(toPicture(pose.position()));
      if (segment.w() == 0) {
        path.append("L").append(end);
      } else if (segment.v() != 0) {
        String radius = number(Math.abs(segment.v() / segment.w()) / grid.resolution());
        String large = Math.abs(segment.angle()) > Math.PI ? "1" : "0";
        String clockwise = segment.w() < 0 ? "1" : "0";
        path.append(String.join(" ", "A" + radius, radius, "0", large, clockwise, end));
      }
    }
    return path.toString();
  }

  private static String point(Vec2 p) {
    return number(p.x()) + " " + number(p.y());
  }
}
