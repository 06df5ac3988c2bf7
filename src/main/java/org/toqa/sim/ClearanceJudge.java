package org.toqa.sim;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Looks at where bodies really are, moment by moment, and keeps how near two of them, and one and a
 * wall, ever came. It knows shapes and walls alone: nothing of what robots take to be true, and
 * nothing that plans. May be used by any thread.
 *
 * <p>Only pairs are measured that can be nearer than the nearest so far: bodies are swept from west
 * to east, so a moment costs the sorting of its bodies and what is near to what.
 */
public final class ClearanceJudge {

  /** Metres; while no wall was seen, none farther than this is looked for. */
  private static final double FARTHEST_WALL = 2;

  /** Null: there are none. */
  private final @Nullable OccupancyGrid walls;

  private @Nullable Clearance betweenBodies;
  private @Nullable Clearance toWall;
  private long samples;
  private long measured;

  /** How far a body reaches, metres, map frame. */
  private record Extent(Body body, double west, double east, double south, double north) {
    static Extent of(Body body) {
      double west = Double.POSITIVE_INFINITY;
      double east = Double.NEGATIVE_INFINITY;
      double south = Double.POSITIVE_INFINITY;
      double north = Double.NEGATIVE_INFINITY;
      for (Vec2 point : body.core()) {
        west = Math.min(west, point.x());
        east = Math.max(east, point.x());
        south = Math.min(south, point.y());
        north = Math.max(north, point.y());
      }
      double radius = body.radius();
      return new Extent(body, west - radius, east + radius, south - radius, north + radius);
    }
  }

  /**
   * How near something came.
   *
   * @param metres between the outlines; 0 or less where they touched
   * @param first the name of a body
   * @param second that of the other, or the cell of the wall
   * @param at the world's time, since its start
   */
  public record Clearance(double metres, String first, String second, Duration at) {
    public boolean isTouch() {
      return metres <= 0;
    }

    /** A sentence for a person. */
    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "%s was %.4f m from %s at %.2f s",
          first,
          metres,
          second,
          at.toNanos() / 1e9);
    }
  }

  /**
   * @param walls cells that are not free, and all that is outside the grid; null: there are none
   */
  public ClearanceJudge(@Nullable OccupancyGrid walls) {
    this.walls = walls;
  }

  /**
   * Looks at all bodies of one moment.
   *
   * @param at the world's time, since its start
   */
  public synchronized void judge(Duration at, List<Body> bodies) {
    samples++;
    List<Extent> extents =
        bodies.stream().map(Extent::of).sorted(Comparator.comparingDouble(Extent::west)).toList();
    for (int i = 0; i < extents.size(); i++) {
      Extent extent = extents.get(i);
      for (int j = i + 1; j < extents.size() && isWorthMeasuring(extent, extents.get(j)); j++) {
        judgePair(extents.get(j).body(), extent.body(), at);
      }
      judgeWalls(extent, at);
    }
  }

  /** Whether the one to the east, or any farther to the east, may be nearer than the nearest. */
  private boolean isWorthMeasuring(Extent one, Extent toEast) {
    return betweenBodies == null || toEast.west() - one.east() < betweenBodies.metres();
  }

  private void judgePair(Body one, Body other, Duration at) {
    measured++;
    double gap = one.gap(other);
    if ((betweenBodies == null || gap < betweenBodies.metres())
        && !one.isCarriedTogetherWith(other)) {
      betweenBodies = new Clearance(gap, one.name(), other.name(), at);
    }
  }

  /** Looks at no cell that cannot be nearer than the nearest so far. */
  private void judgeWalls(Extent extent, Duration at) {
    if (walls == null) {
      return;
    }
    Body body = extent.body();
    double reach = (toWall == null ? FARTHEST_WALL : Math.max(0, toWall.metres())) + 1e-9;
    Cell upperLeft = walls.cellAt(new Vec2(extent.west() - reach, extent.north() + reach));
    Cell lowerRight = walls.cellAt(new Vec2(extent.east() + reach, extent.south() - reach));
    for (int row = upperLeft.row(); row <= lowerRight.row(); row++) {
      for (int column = upperLeft.column(); column <= lowerRight.column(); column++) {
        Cell cell = new Cell(column, row);
        if (!walls.isFree(cell)) {
          double gap = body.gap(walls, cell);
          if (toWall == null || gap < toWall.metres()) {
            toWall = new Clearance(gap, body.name(), "wall " + cell, at);
          }
        }
      }
    }
  }

  /** The nearest that two bodies came; empty where there were no two. */
  public synchronized Optional<Clearance> betweenBodies() {
    return Optional.ofNullable(betweenBodies);
  }

  /** The nearest that a body came to a wall; empty where none came within two metres. */
  public synchronized Optional<Clearance> toWall() {
    return Optional.ofNullable(toWall);
  }

  /** The moments that were looked at. */
  public synchronized long samples() {
    return samples;
  }

  /** How many pairs of bodies were measured. */
  synchronized long measured() {
    return measured;
  }
}
