package org.toqa.fleet.supervision;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Base64;
import java.util.BitSet;
import java.util.Deque;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

/**
 * What cameras have seen of a floor, cell by cell; what they have not seen is not known. Where to
 * look next is the nearest place from which something unseen is in view. For one thread.
 */
final class SeenArea {
  private static final int LEAST_RAYS = 360;

  /** Metres: a view from there must come so much nearer than cameras see. */
  private static final double CERTAIN = 0.9;

  /** Bytes; a floor that packs worse is looked at anew after a restart. */
  private static final int LONGEST_TEXT = 60_000;

  private final OccupancyGrid walls;
  private final OccupancyGrid drivable;
  private final BitSet seen;

  /**
   * @param clearance metres between a robot's middle and walls
   * @param text of before; empty: nothing was seen
   */
  SeenArea(FloorMap floor, double clearance, String text) {
    walls = floor.drawing().walls();
    drivable = Inflation.inflate(floor.grid(), clearance);
    seen = unpack(text);
  }

  /** Looks all round; whether there was anything new. */
  boolean look(Vec2 from, double range) {
    int before = seen.cardinality();
    double step = walls.resolution() / 2;
    int rays = (int) Math.max(LEAST_RAYS, Math.ceil(2 * Math.PI * range / step));
    for (int i = 0; i < rays; i++) {
      double angle = 2 * Math.PI * i / rays;
      double reach = RayCast.distance(walls, from, angle, range);
      Vec2 along = new Vec2(Math.cos(angle), Math.sin(angle));
      for (double d = 0; d < reach; d += step) {
        mark(walls.cellAt(from.plus(along.times(d))));
      }
    }
    return seen.cardinality() > before;
  }

  private void mark(Cell cell) {
    if (walls.contains(cell) && walls.isFree(cell)) {
      seen.set(walls.index(cell));
    }
  }

  /** What was seen counts no more: something is not where it was. */
  void forget() {
    seen.clear();
  }

  /** Whether everything that can be seen was. */
  boolean isComplete() {
    return unseen().isEmpty();
  }

  /** How much of what can be seen was, 0 to 1. */
  double share() {
    int all = walls.width() * walls.height() - walls.occupied().cardinality();
    return all == 0 ? 1 : (double) seen.cardinality() / all;
  }

  private BitSet unseen() {
    BitSet unseen = new BitSet();
    unseen.set(0, walls.width() * walls.height());
    unseen.andNot(walls.occupied());
    unseen.andNot(seen);
    return unseen;
  }

  /**
   * Where to drive, to see more.
   *
   * @param from where the robot is
   * @param range metres that its cameras see
   * @return the middle of a cell; empty: nothing more can be seen from anywhere, and that is noted
   */
  Optional<Vec2> nextView(Vec2 from, double range) {
    BitSet unseen = unseen();
    if (unseen.isEmpty()) {
      return Optional.empty();
    }
    Cell start = drivable.cellAt(from);
    BitSet visited = new BitSet();
    Deque<Cell> queue = new ArrayDeque<>();
    queue.add(start);
    while (!queue.isEmpty()) {
      Cell cell = queue.remove();
      if (isView(cell, unseen, range * CERTAIN)) {
        return Optional.of(drivable.centre(cell));
      }
      for (int[] side : new int[][] {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
        Cell next = new Cell(cell.column() + side[0], cell.row() + side[1]);
        if (drivable.contains(next)
            && drivable.isFree(next)
            && !visited.get(drivable.index(next))) {
          visited.set(drivable.index(next));
          queue.add(next);
        }
      }
    }
    seen.or(unseen); // behind what nobody can drive round
    return Optional.empty();
  }

  /** Whether something unseen is in view from the middle of a cell. */
  private boolean isView(Cell cell, BitSet unseen, double range) {
    if (!drivable.contains(cell) || !drivable.isFree(cell)) {
      return false;
    }
    Vec2 from = drivable.centre(cell);
    int reach = (int) (range / walls.resolution());
    for (int row = cell.row() - reach; row <= cell.row() + reach; row++) {
      for (int column = cell.column() - reach; column <= cell.column() + reach; column++) {
        if (walls.contains(column, row) && unseen.get(row * walls.width() + column)) {
          Vec2 way = walls.centre(new Cell(column, row)).minus(from);
          double metres = way.norm();
          if (metres <= range
              && RayCast.distance(walls, from, way.angle(), metres) >= metres - 1e-9) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** There is nothing to be seen round a place that was looked at from near. */
  void giveUpRound(Vec2 place, double range) {
    int reach = (int) Math.ceil(range / walls.resolution());
    walls.cellsAround(place, reach).forEach(this::mark);
  }

  /** For the store: the cells that were seen, packed; empty where that is too long. */
  String text() {
    Deflater deflater = new Deflater();
    try {
      deflater.setInput(seen.toByteArray());
      deflater.finish();
      ByteArrayOutputStream packed = new ByteArrayOutputStream();
      byte[] part = new byte[8192];
      while (!deflater.finished()) {
        packed.write(part, 0, deflater.deflate(part));
      }
      String text = Base64.getEncoder().encodeToString(packed.toByteArray());
      return text.length() > LONGEST_TEXT ? "" : text;
    } finally {
      deflater.end();
    }
  }

  /** Of another map than this nothing is kept that is no free cell. */
  private BitSet unpack(@Nullable String text) {
    if (text == null || text.isEmpty()) {
      return new BitSet();
    }
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(Base64.getDecoder().decode(text));
      byte[] bytes = new byte[(walls.width() * walls.height() + 7) / 8];
      int length = inflater.inflate(bytes);
      BitSet cells = BitSet.valueOf(ByteBuffer.wrap(bytes, 0, length));
      cells.andNot(walls.occupied());
      return cells;
    } catch (DataFormatException | IllegalArgumentException e) {
      return new BitSet(); // it is looked at anew
    } finally {
      inflater.end();
    }
  }
}
