package org.toqa.planning.smooth;

import java.util.BitSet;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/** Random queries, and what is true of them by brute force: each occupied square, one by one. */
public final class Scenes {
  private Scenes() {}

  /**
   * @param radius metres, as all here
   */
  public record Query(OccupancyGrid grid, double radius, Vec2 from, Vec2 to) {
    @Override
    public String toString() {
      StringBuilder text = new StringBuilder();
      for (int row = 0; row < grid.height(); row++) {
        text.append('\n');
        for (int column = 0; column < grid.width(); column++) {
          text.append(grid.isFree(column, row) ? '.' : '@');
        }
      }
      return "radius %s from %s to %s on cells of %s m at %s:%s"
          .formatted(radius, from, to, grid.resolution(), grid.origin(), text);
    }
  }

  /** Small grids with few to many squares; radii among which are such that just fit. */
  public static Arbitrary<Query> queries() {
    Arbitrary<OccupancyGrid> grids =
        Arbitraries.integers()
            .between(3, 14)
            .flatMap(
                width ->
                    Arbitraries.integers().between(3, 14).flatMap(height -> grids(width, height)));
    Arbitrary<Double> radii =
        Arbitraries.oneOf(
            Arbitraries.of(0.5, 1.0, 1.5, Math.sqrt(5) / 2, 2.5),
            Arbitraries.doubles().between(0.05, 2.5));
    Arbitrary<Double> shares = Arbitraries.doubles().between(0, 1);
    return Combinators.combine(grids, radii, shares, shares, shares, shares)
        .as(
            (grid, radius, a, b, c, d) ->
                new Query(grid, radius * grid.resolution(), place(grid, a, b), place(grid, c, d)));
  }

  private static Arbitrary<OccupancyGrid> grids(int width, int height) {
    return Combinators.combine(
            Arbitraries.integers()
                .between(0, width * height - 1)
                .set()
                .ofMaxSize(width * height / 3),
            Arbitraries.of(0.01, 0.25, 1.0))
        .as(
            (walls, resolution) -> {
              BitSet occupied = new BitSet();
              walls.forEach(occupied::set);
              return new OccupancyGrid(width, height, resolution, new Vec2(-3, 7), occupied);
            });
  }

  /** Mostly the middle of a cell, where what just fits is. */
  private static Vec2 place(OccupancyGrid grid, double east, double north) {
    double x = east * grid.width();
    double y = north * grid.height();
    boolean isAnywhere = Math.round(x * 100) % 3 == 0;
    double cellX = isAnywhere ? x : Math.round(x * 2) / 2.0;
    double cellY = isAnywhere ? y : Math.round(y * 2) / 2.0;
    return grid.origin().plus(new Vec2(cellX, cellY).times(grid.resolution()));
  }

  /** From a line to the nearest wall or the border, metres; 0 where it meets one. */
  public static double clearance(OccupancyGrid grid, Vec2 from, Vec2 to) {
    Vec2 upper = grid.origin().plus(new Vec2(grid.width(), grid.height()).times(grid.resolution()));
    double nearest = Double.POSITIVE_INFINITY;
    for (Vec2 end : List.of(from, to)) {
      nearest = Math.min(nearest, Math.min(end.x() - grid.origin().x(), upper.x() - end.x()));
      nearest = Math.min(nearest, Math.min(end.y() - grid.origin().y(), upper.y() - end.y()));
    }
    BitSet occupied = grid.occupied();
    for (int i = occupied.nextSetBit(0); i >= 0; i = occupied.nextSetBit(i + 1)) {
      nearest = Math.min(nearest, toSquare(from, to, grid.centre(grid.cell(i)), grid));
    }
    return Math.max(0, nearest);
  }

  private static double toSquare(Vec2 from, Vec2 to, Vec2 centre, OccupancyGrid grid) {
    double half = grid.resolution() / 2;
    Vec2 a = centre.plus(new Vec2(-half, -half));
    Vec2 b = centre.plus(new Vec2(half, -half));
    Vec2 c = centre.plus(new Vec2(half, half));
    Vec2 d = centre.plus(new Vec2(-half, half));
    Vec2 away = from.minus(centre);
    if (Math.max(Math.abs(away.x()), Math.abs(away.y())) <= half) {
      return 0;
    }
    return Math.min(
        Math.min(
            Vec2.distanceBetweenLines(from, to, a, b), Vec2.distanceBetweenLines(from, to, b, c)),
        Math.min(
            Vec2.distanceBetweenLines(from, to, c, d), Vec2.distanceBetweenLines(from, to, d, a)));
  }

  /** The least clearance of the lines through points, metres. */
  public static double clearance(OccupancyGrid grid, List<Vec2> points) {
    double nearest = clearance(grid, points.getFirst(), points.getFirst());
    for (int i = 1; i < points.size(); i++) {
      nearest = Math.min(nearest, clearance(grid, points.get(i - 1), points.get(i)));
    }
    return nearest;
  }
}
