package org.toqa.app.plan;

import java.util.Formatter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.planning.Path;

/** A plan for people, in a terminal. */
final class PlanTable {
  private static final int CELLS_A_LINE = 8;

  private PlanTable() {}

  static String of(PlannedDrive drive) {
    Formatter table = new Formatter(Locale.ROOT);
    addSummary(table, drive);
    addCells(table, drive.path().cells());
    addSegments(table, drive.trajectory());
    return table.toString().stripTrailing();
  }

  private static void addSummary(Formatter table, PlannedDrive drive) {
    Path path = drive.path();
    Trajectory trajectory = drive.trajectory();
    addPlace(table, "from", path.cells().getFirst(), drive.inflated());
    addPlace(table, "to", path.cells().getLast(), drive.inflated());
    table.format("cost    %.3f cells%n", path.cost());
    table.format("length  %.3f m driven%n", trajectory.length());
    table.format("time    %.1f s%n", trajectory.duration());
    table.format("turns   %d on the spot%n", path.turnsOnSpot());
  }

  private static void addPlace(Formatter table, String name, Cell cell, OccupancyGrid grid) {
    Vec2 centre = grid.centre(cell);
    table.format("%-8s%.3f, %.3f m, cell %s%n", name, centre.x(), centre.y(), cell);
  }

  private static void addCells(Formatter table, List<Cell> cells) {
    for (int first = 0; first < cells.size(); first += CELLS_A_LINE) {
      List<Cell> line = cells.subList(first, Math.min(cells.size(), first + CELLS_A_LINE));
      String words = line.stream().map(Cell::toString).collect(Collectors.joining(" "));
      table.format("%-8s%s%n", first == 0 ? "cells" : "", words);
    }
  }

  static void addSegments(Formatter table, Trajectory trajectory) {
    table.format("%n segment  v (m/s)  w (rad/s)    t (s)  then at x (m)    y (m)  degrees%n");
    int number = 1;
    Pose pose = trajectory.start();
    for (Segment s : trajectory.segments()) {
      pose = pose.advanced(s.twist(), s.t());
      table.format("%8d %8.3f %10.3f %8.3f", number++, s.v(), s.w(), s.t());
      table.format(
          "%15.3f %8.3f %8d%n", pose.x(), pose.y(), Math.round(Math.toDegrees(pose.theta())));
    }
  }
}
