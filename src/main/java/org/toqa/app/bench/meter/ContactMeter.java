package org.toqa.app.bench.meter;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Looks at where many discs of one size really are, moment by moment: how often two of them came to
 * touch, or one and a wall, and how near they came. It knows shapes and walls alone. As {@link
 * org.toqa.sim.ClearanceJudge}, but at a cost linear in the discs that moved.
 */
public final class ContactMeter {
  /** Metres; pairs farther apart than this, and walls, are not looked at. */
  private static final double FARTHEST = 2;

  private static final int NONE = -1;

  private final OccupancyGrid walls;
  private final double radius;
  private final double[] x;
  private final double[] y;

  // squares of a side in which only neighbours can be near; each has a list of its discs
  private final double side;
  private final int columns;
  private final int rows;
  private final int[] first;
  private final int[] next;
  private final int[] square;

  private final Set<Long> touching = new HashSet<>();
  private final boolean[] atWall;
  private int contacts;
  private int wallContacts;
  private double nearest = Double.POSITIVE_INFINITY;
  private double nearestWall = Double.POSITIVE_INFINITY;

  /**
   * @param walls cells that are not free, and all that is outside the grid
   * @param radius metres
   */
  public ContactMeter(OccupancyGrid walls, int discs, double radius) {
    this.walls = walls;
    this.radius = radius;
    side = 2 * radius + FARTHEST;
    columns = (int) Math.ceil(walls.width() * walls.resolution() / side) + 2;
    rows = (int) Math.ceil(walls.height() * walls.resolution() / side) + 2;
    x = new double[discs];
    y = new double[discs];
    first = new int[columns * rows];
    next = new int[discs];
    square = new int[discs];
    atWall = new boolean[discs];
    Arrays.fill(first, NONE);
    Arrays.fill(square, NONE);
  }

  /** The disc is there now, map frame; to be said of all before {@link #judge} is asked. */
  public void place(int disc, Vec2 at) {
    x[disc] = at.x();
    y[disc] = at.y();
    int now = squareAt(at.x(), at.y());
    if (now != square[disc]) {
      remove(disc);
      square[disc] = now;
      next[disc] = first[now];
      first[now] = disc;
    }
  }

  private int squareAt(double px, double py) {
    int column = (int) Math.floor((px - walls.origin().x()) / side) + 1;
    int row = (int) Math.floor((py - walls.origin().y()) / side) + 1;
    return Math.clamp(row, 0, rows - 1) * columns + Math.clamp(column, 0, columns - 1);
  }

  private void remove(int disc) {
    if (square[disc] == NONE) {
      return;
    }
    if (first[square[disc]] == disc) {
      first[square[disc]] = next[disc];
    } else {
      int before = first[square[disc]];
      while (next[before] != disc) {
        before = next[before];
      }
      next[before] = next[disc];
    }
  }

  /** Looks at one that has moved, and all near it. */
  public void judge(int disc) {
    for (int row = -1; row <= 1; row++) {
      for (int column = -1; column <= 1; column++) {
        int index = square[disc] + row * columns + column;
        if (index >= 0 && index < first.length) {
          for (int other = first[index]; other != NONE; other = next[other]) {
            if (other != disc) {
              judgePair(disc, other);
            }
          }
        }
      }
    }
    judgeWalls(disc);
  }

  private void judgePair(int one, int other) {
    double gap = Math.hypot(x[one] - x[other], y[one] - y[other]) - 2 * radius;
    nearest = Math.min(nearest, gap);
    long pair = (long) Math.min(one, other) * next.length + Math.max(one, other);
    if (gap > 0) {
      touching.remove(pair);
    } else if (touching.add(pair)) {
      contacts++;
    }
  }

  private void judgeWalls(int disc) {
    double reach = radius + Math.min(FARTHEST, Math.max(0, nearestWall));
    Cell upperLeft = walls.cellAt(new Vec2(x[disc] - reach, y[disc] + reach));
    Cell lowerRight = walls.cellAt(new Vec2(x[disc] + reach, y[disc] - reach));
    boolean touches = false;
    for (int row = upperLeft.row(); row <= lowerRight.row(); row++) {
      for (int column = upperLeft.column(); column <= lowerRight.column(); column++) {
        if (!walls.isFree(column, row)) {
          double gap = gapToCell(disc, new Cell(column, row));
          nearestWall = Math.min(nearestWall, gap);
          touches |= gap <= 0;
        }
      }
    }
    if (touches && !atWall[disc]) {
      wallContacts++;
    }
    atWall[disc] = touches;
  }

  private double gapToCell(int disc, Cell cell) {
    Vec2 centre = walls.centre(cell);
    double half = walls.resolution() / 2;
    double dx = Math.max(0, Math.abs(x[disc] - centre.x()) - half);
    double dy = Math.max(0, Math.abs(y[disc] - centre.y()) - half);
    return Math.hypot(dx, dy) - radius;
  }

  /** How often two discs came to touch. */
  public int contacts() {
    return contacts;
  }

  /** How often a disc came to touch a wall. */
  public int wallContacts() {
    return wallContacts;
  }

  /** Metres between the edges of the two that came nearest; null: none came near. */
  public @Nullable Double nearest() {
    return nearest < FARTHEST ? nearest : null;
  }

  /** Metres between an edge and a wall, likewise. */
  public @Nullable Double nearestWall() {
    return nearestWall < FARTHEST ? nearestWall : null;
  }
}
