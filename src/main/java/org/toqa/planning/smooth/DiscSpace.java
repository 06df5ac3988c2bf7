package org.toqa.planning.smooth;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.Passages.Passage;

/**
 * Where the centre of a disc may be on a grid (its configuration space: Lozano-Perez, "Spatial
 * planning", 1983). Occupied cells are closed squares and everything outside the grid is wall; the
 * disc may touch, so its centre is free where it is at least the radius away from all of them. What
 * is said of a straight line holds for each of its points: nothing is sampled.
 *
 * <p>A line is walked by leaps that the exact distance at a point allows (Hart, "Sphere tracing",
 * 1996), and near walls cell by cell with exact distances from the line to squares.
 *
 * <p>Immutable as far as callers can tell, and safe for any number of threads: what is near a cell
 * is found when it is first asked for.
 */
public final class DiscSpace {
  /** Cells; far below what a map can mean, far above what rounding does. */
  static final double TOLERANCE = 1e-9;

  /** Radii up to which distances are told; beyond, it is said only that they are larger. */
  private static final double HORIZON = 2;

  /** Cells by which the horizon is at most more than the radius. */
  private static final double MOST_BEYOND = 16;

  /** Cells; shorter leaps are not worth a distance. */
  private static final double SHORTEST_LEAP = 0.7;

  /** Cells from a border at which a line is already in the cell that it enters. */
  private static final double AT_BORDER = 1e-9;

  private final OccupancyGrid grid;
  private final double radius;
  private final double horizon;
  private final NearbySquares nearby;
  private final List<Passage> passages;
  private final Lattice lattice;

  private DiscSpace(OccupancyGrid grid, double radius) {
    this.grid = grid;
    this.radius = radius - Math.min(TOLERANCE, radius / 2);
    this.horizon = Math.min(Math.max(HORIZON * radius, 2), radius + MOST_BEYOND);
    this.nearby = new NearbySquares(grid, horizon);
    this.passages = Passages.of(this);
    this.lattice = new Lattice(this);
  }

  /**
   * Lays a grid out.
   *
   * @param radius of the disc, metres, above 0
   * @throws IllegalArgumentException if the radius is not positive and finite
   */
  public static DiscSpace of(OccupancyGrid grid, double radius) {
    if (!(radius > 0) || Double.isInfinite(radius)) {
      throw new IllegalArgumentException("A disc has a positive radius, not " + radius + " m.");
    }
    return new DiscSpace(grid, radius / grid.resolution());
  }

  /** The grid it was made of. */
  public OccupancyGrid grid() {
    return grid;
  }

  /** The disc's radius, metres. */
  public double radius() {
    return (radius + TOLERANCE) * grid.resolution();
  }

  /** Whether the disc may stand with its centre at a point, metres, map frame. */
  public boolean isFree(Vec2 point) {
    return isFree(toCellsX(point.x()), toCellsY(point.y()));
  }

  /** Whether its centre may go along a straight line between points, metres, map frame. */
  public boolean isFree(Vec2 from, Vec2 to) {
    return isFree(toCellsX(from.x()), toCellsY(from.y()), toCellsX(to.x()), toCellsY(to.y()));
  }

  /**
   * Whether the centre of a disc that is larger by a margin may go along a straight line.
   *
   * @param from metres, map frame
   * @param to metres, map frame
   * @param margin metres, at least 0; one that is larger than the radius may be refused
   */
  public boolean isFree(Vec2 from, Vec2 to, double margin) {
    return isFree(
        toCellsX(from.x()),
        toCellsY(from.y()),
        toCellsX(to.x()),
        toCellsY(to.y()),
        radius + margin / grid.resolution());
  }

  /**
   * A point at least the radius and a margin away from the nearest wall: the same one, or one that
   * is moved straight away from that wall, if it is free.
   *
   * @param point metres, map frame
   * @param margin metres
   */
  public Vec2 awayFromWalls(Vec2 point, double margin) {
    double x = toCellsX(point.x());
    double y = toCellsY(point.y());
    double wanted = radius + margin / grid.resolution();
    double distance = distance(x, y);
    Vec2 wall = distance >= wanted || distance == 0 ? null : nearestWall(x, y);
    if (wall == null) {
      return point;
    }
    double factor = wanted / distance;
    double movedX = wall.x() + factor * (x - wall.x());
    double movedY = wall.y() + factor * (y - wall.y());
    return isFree(movedX, movedY) ? toMetres(movedX, movedY) : point;
  }

  double toCellsX(double metres) {
    return (metres - grid.origin().x()) / grid.resolution();
  }

  double toCellsY(double metres) {
    return (metres - grid.origin().y()) / grid.resolution();
  }

  /** A point of the map frame, metres, of one in cells. */
  Vec2 toMetres(double x, double y) {
    return new Vec2(
        grid.origin().x() + x * grid.resolution(), grid.origin().y() + y * grid.resolution());
  }

  /** Cells from west to east. */
  int width() {
    return nearby.width();
  }

  /** Cells from south to north. */
  int height() {
    return nearby.height();
  }

  /** The disc's radius in cells, less the tolerance. */
  double radiusInCells() {
    return radius;
  }

  /** The passages that are hardly wider than the disc. */
  List<Passage> passages() {
    return passages;
  }

  /** Where first paths are searched. */
  Lattice lattice() {
    return lattice;
  }

  /** Whether a cell is occupied or outside the grid; row 0 is the lowest. */
  boolean isOccupied(int column, int row) {
    return nearby.isOccupied(column, row);
  }

  /** Whether the disc may stand with its centre there; cells. */
  boolean isFree(double x, double y) {
    return distance(x, y) >= radius && isOnGrid(x, y);
  }

  /**
   * The exact distance from a point to the nearest wall, but no more than a horizon of at least
   * twice the radius; 0 in a wall. Cells.
   */
  double distance(double x, double y) {
    return Math.sqrt(squaredDistance(nearby.of((int) Math.floor(x), (int) Math.floor(y)), x, y));
  }

  /**
   * The point of a wall that is nearest to a point outside of all walls; null beyond the horizon.
   */
  @Nullable Vec2 nearestWall(double x, double y) {
    int[] squares = nearby.of((int) Math.floor(x), (int) Math.floor(y));
    Vec2 nearest = null;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < squares.length; i += 2) {
      double wallX = Math.clamp(x, squares[i], squares[i] + 1.0);
      double wallY = Math.clamp(y, squares[i + 1], squares[i + 1] + 1.0);
      double distance = WayPoints.distance(x, y, wallX, wallY);
      if (distance < least) {
        least = distance;
        nearest = new Vec2(wallX, wallY);
      }
    }
    return nearest;
  }

  /** Whether the disc's centre may go along a straight line; cells. */
  boolean isFree(double fromX, double fromY, double toX, double toY) {
    return isFree(fromX, fromY, toX, toY, radius);
  }

  /**
   * @param reach cells that must be free on all sides; beyond the horizon the answer is no
   */
  boolean isFree(double fromX, double fromY, double toX, double toY, double reach) {
    if (reach > horizon || !isOnGrid(fromX, fromY) || !isOnGrid(toX, toY)) {
      return false;
    }
    double alongX = toX - fromX;
    double alongY = toY - fromY;
    double length = Math.sqrt(alongX * alongX + alongY * alongY);
    double squaredReach = reach * reach;
    double walked = 0;
    while (true) {
      double share = length == 0 ? 0 : walked / length;
      double x = fromX + share * alongX;
      double y = fromY + share * alongY;
      int column = (int) Math.floor(x + Math.signum(alongX) * AT_BORDER);
      int row = (int) Math.floor(y + Math.signum(alongY) * AT_BORDER);
      int[] squares = nearby.of(column, row);
      double squared = squaredDistance(squares, x, y);
      if (squared < squaredReach) {
        return false;
      }
      double leap = Math.sqrt(squared) - reach;
      if (leap < SHORTEST_LEAP) {
        for (int i = 0; i < squares.length; i += 2) {
          if (squaredDistance(fromX, fromY, toX, toY, squares[i], squares[i + 1]) < squaredReach) {
            return false;
          }
        }
        double toBorder = Math.min(toBorder(x, alongX, column), toBorder(y, alongY, row));
        leap = Math.max(leap, toBorder * length);
      }
      walked += leap;
      if (!(walked < length)) {
        return length == 0 || isFreeAtEnd(toX, toY, squaredReach);
      }
    }
  }

  private boolean isFreeAtEnd(double x, double y, double squaredReach) {
    return squaredDistance(nearby.of((int) Math.floor(x), (int) Math.floor(y)), x, y)
        >= squaredReach;
  }

  private boolean isOnGrid(double x, double y) {
    return x >= 0 && y >= 0 && x <= nearby.width() && y <= nearby.height();
  }

  /** The share of the line after which it leaves the cell along one axis. */
  private static double toBorder(double at, double along, int cell) {
    if (along > 0) {
      return (cell + 1 - at) / along;
    }
    return along < 0 ? (cell - at) / along : Double.POSITIVE_INFINITY;
  }

  /** To the nearest of these squares, at most the horizon. */
  private double squaredDistance(int[] squares, double x, double y) {
    if (squares == NearbySquares.OCCUPIED) {
      return 0;
    }
    double nearest = horizon * horizon;
    for (int i = 0; i < squares.length; i += 2) {
      double east = Math.max(0, Math.max(squares[i] - x, x - squares[i] - 1));
      double north = Math.max(0, Math.max(squares[i + 1] - y, y - squares[i + 1] - 1));
      nearest = Math.min(nearest, east * east + north * north);
    }
    return nearest;
  }

  /** Between a line and the unit square with that lower left corner; 0 where they meet. */
  static double squaredDistance(
      double fromX, double fromY, double toX, double toY, int left, int bottom) {
    double ax = fromX - left - 0.5;
    double ay = fromY - bottom - 0.5;
    double bx = toX - left - 0.5;
    double by = toY - bottom - 0.5;
    double dx = bx - ax;
    double dy = by - ay;
    // beside the square as seen along the line, or the line passes on one side of all corners
    double cross = ax * dy - ay * dx;
    double half = (Math.abs(dx) + Math.abs(dy)) / 2;
    boolean meets =
        Math.abs(cross) <= half
            && Math.min(ax, bx) <= 0.5
            && Math.max(ax, bx) >= -0.5
            && Math.min(ay, by) <= 0.5
            && Math.max(ay, by) >= -0.5;
    if (meets) {
      return 0;
    }
    double nearest = Math.min(squaredToSquare(ax, ay), squaredToSquare(bx, by));
    double squaredLength = dx * dx + dy * dy;
    if (squaredLength > 0) {
      for (int corner = 0; corner < 4; corner++) {
        double px = ((corner & 1) == 0 ? -0.5 : 0.5) - ax;
        double py = ((corner & 2) == 0 ? -0.5 : 0.5) - ay;
        double along = px * dx + py * dy;
        if (along > 0 && along < squaredLength) {
          double across = px * dy - py * dx;
          nearest = Math.min(nearest, across * across / squaredLength);
        }
      }
    }
    return nearest;
  }

  private static double squaredToSquare(double x, double y) {
    double east = Math.max(0, Math.abs(x) - 0.5);
    double north = Math.max(0, Math.abs(y) - 0.5);
    return east * east + north * north;
  }
}
