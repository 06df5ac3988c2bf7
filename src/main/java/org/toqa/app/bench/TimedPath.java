package org.toqa.app.bench;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.PlanResult;

/** A path that a robot drives at constant speed, beginning at some moment. */
final class TimedPath {
  private static final JumpPointSearch PLANNER = new JumpPointSearch();

  private final Instant start;
  private final double speed;
  private final Vec2[] points;

  /** Metres from the beginning, by point. */
  private final double[] metres;

  /**
   * @param grid inflated by the robot's radius
   * @param from metres, map frame
   * @param to metres, map frame
   * @param speed metres a second, above 0
   * @throws IllegalStateException there is no path from the one to the other
   */
  TimedPath(OccupancyGrid grid, Vec2 from, Vec2 to, Instant begin, double speed) {
    this.speed = speed;
    this.start = begin;
    List<Cell> cells =
        switch (PLANNER.plan(grid, grid.cellAt(from), grid.cellAt(to))) {
          case PlanResult.Found(var path) -> path.cells();
          case PlanResult.NotFound none ->
              throw new IllegalStateException("There is no path from " + from + " to " + to);
        };
    points = cells.stream().map(grid::centre).toArray(Vec2[]::new);
    metres = new double[points.length];
    for (int i = 1; i < points.length; i++) {
      metres[i] = metres[i - 1] + points[i].distanceTo(points[i - 1]);
    }
  }

  /** When the robot is at the end. */
  Instant end() {
    double seconds = metres[metres.length - 1] / speed;
    return start.plus(Duration.ofNanos(Math.round(seconds * 1e9)));
  }

  /**
   * The point that was reached last, metres, map frame.
   *
   * @param time not before the start
   */
  Vec2 positionAt(Instant time) {
    return points[lastPassedPoint(time)];
  }

  /**
   * Metres driven to that point.
   *
   * @param time not before the start
   */
  double drivenMetres(Instant time) {
    return metres[lastPassedPoint(time)];
  }

  private int lastPassedPoint(Instant time) {
    double driven = Duration.between(start, time).toNanos() / 1e9 * speed + 1e-6;
    int passed = Arrays.binarySearch(metres, driven);
    return passed >= 0 ? passed : -passed - 2;
  }
}
