package org.toqa.sim;

import java.time.Duration;
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
 */
public final class ClearanceJudge {

  /** Metres; while no wall was seen, none farther than this is looked for. */
  private static final double FARTHEST_WALL = 2;

  /** Null: there are none. */
  private final @Nullable OccupancyGrid walls;

  private @Nullable Clearance betweenBodies;
  private @Nullable Clearance toWall;
  private long samples;

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
    for (int i = 0; i < bodies.size(); i++) {
      Body body = bodies.get(i);
      for (int j = 0; j < i; j++) {
        judgePair(body, bodies.get(j), at);
      }
      judgeWalls(body, at);
    }
  }

  private void judgePair(Body one, Body other, Duration at) {
    double gap = one.gap(other);
    if ((betweenBodies == null || gap < betweenBodies.metres())
        && !one.isCarriedTogetherWith(other)) {
      betweenBodies = new Clearance(gap, one.name(), other.name(), at);
    }
  }

  /** Looks at no cell that cannot be nearer than the nearest so far. */
  private void judgeWalls(Body body, Duration at) {
    if (walls == null) {
      return;
    }
    double reach =
        body.radius() + (toWall == null ? FARTHEST_WALL : Math.max(0, toWall.metres())) + 1e-9;
    double west = body.core().stream().mapToDouble(Vec2::x).min().orElseThrow() - reach;
    double east = body.core().stream().mapToDouble(Vec2::x).max().orElseThrow() + reach;
    double south = body.core().stream().mapToDouble(Vec2::y).min().orElseThrow() - reach;
    double north = body.core().stream().mapToDouble(Vec2::y).max().orElseThrow() + reach;
    Cell upperLeft = walls.cellAt(new Vec2(west, north));
    Cell lowerRight = walls.cellAt(new Vec2(east, south));
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
}
