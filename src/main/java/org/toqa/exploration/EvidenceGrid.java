package org.toqa.exploration;

import java.util.BitSet;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

/**
 * A map that is made of what lidars read: for each cell the logarithm of the odds that it is
 * occupied, to which each ray adds (Moravec and Elfes, "High resolution maps from wide angle
 * sonar", ICRA 1985; in this form Thrun, Burgard, Fox, "Probabilistic Robotics", 2005, tables 9.1
 * and 9.2).
 *
 * <p>A ray makes the cells before its end more likely free, and that in which it ends more likely
 * occupied. A cell is occupied where that is more likely, free where two rays more have told so,
 * and else unknown. Odds are bounded, so that what has moved away is forgotten.
 */
public final class EvidenceGrid {
  // l(p) = ln(p / (1 - p)): a cell in which a ray ends is occupied with 0.7, one before it with 0.4
  private static final float HIT = (float) Math.log(0.7 / 0.3);
  private static final float MISS = (float) Math.log(0.4 / 0.6);
  private static final float BOUND = 4;

  /** More than one ray must tell that a cell is free: a single one may have read too far. */
  private static final float FREE = -0.5f;

  /** Metres; a ray that is in a cell for less has only touched its corner. */
  private static final double TOUCH = 1e-6;

  private final int width;
  private final int height;
  private final double resolution;
  private final Vec2 origin;
  private final float[] odds;
  private final BitSet occupied = new BitSet();
  private final BitSet free = new BitSet();

  /**
   * Of which nothing is known. Cells are those of an {@link OccupancyGrid} of that size.
   *
   * @param resolution metres along a cell's side
   * @param origin metres, the lower left corner in the map frame
   */
  public EvidenceGrid(int width, int height, double resolution, Vec2 origin) {
    this.width = width;
    this.height = height;
    this.resolution = resolution;
    this.origin = origin;
    this.odds = new float[width * height];
  }

  /**
   * Adds what a ray told.
   *
   * @param from metres, map frame
   * @param direction radians, counter-clockwise from map east
   * @param range metres that it read
   * @param isHit whether it met something there; otherwise it met nothing so far
   */
  public void addRay(Vec2 from, double direction, double range, boolean isHit) {
    // what reflects lies behind the point that was measured, by half a cell on average
    double end = range + (isHit ? resolution / 2 : 0);
    double freeUntil = range - (isHit ? resolution / 2 : 0);
    RayCast.walk(
        resolution,
        from.minus(origin),
        direction,
        end,
        (column, up, entered, left) -> {
          if (column < 0 || up < 0 || column >= width || up >= height) {
            return false;
          }
          boolean isLast = left >= end;
          if (isLast && isHit) {
            add((height - 1 - up) * width + column, HIT);
          } else if (entered < freeUntil && left - entered > TOUCH) {
            add((height - 1 - up) * width + column, MISS);
          }
          return !isLast;
        });
  }

  private void add(int cell, float evidence) {
    // l = l + l(p | z), the prior being even   (table 9.1)
    float sum = Math.clamp(odds[cell] + evidence, -BOUND, BOUND);
    odds[cell] = sum;
    occupied.set(cell, sum > 0);
    free.set(cell, sum < FREE);
  }

  /** As far as is known: occupied is what was seen so, and free is all else, also the unknown. */
  public OccupancyGrid optimistic() {
    return new OccupancyGrid(width, height, resolution, origin, occupied);
  }

  /** What is known now. */
  public SeenGround seen() {
    return new SeenGround(
        width, height, resolution, origin, CellRuns.of(free), CellRuns.of(occupied));
  }
}
