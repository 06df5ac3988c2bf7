package org.toqa.fleet.supervision;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Base64;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

/**
 * What cameras have seen of a floor, cell by cell; what they have not seen is not known. Where to
 * look next is the nearest place from which something unseen is in view. For one thread.
 */
final class SeenArea {
  /** Metres: a view from there must come so much nearer than cameras see. */
  private static final double CERTAIN = 0.9;

  /** Bytes; a floor that packs worse is looked at anew after a restart. */
  private static final int LONGEST_TEXT = 60_000;

  private final OccupancyGrid walls;
  private final DrivableArea area;
  private final BitSet seen;

  /** Views that did not show what they should, or could not be reached. */
  private final BitSet givenUp = new BitSet();

  /** Where the robot's middle can be, now. */
  private OccupancyGrid drivable;

  private List<Vec2> boxes = List.of();

  /** What was unseen when boxes kept the robot from all views; null: they do not. */
  private @Nullable BitSet unseenBehindBoxes;

  /**
   * @param clearance metres between a robot's middle and walls
   * @param text of before; empty: nothing was seen
   */
  SeenArea(FloorMap floor, double clearance, String text) {
    walls = floor.drawing().walls();
    area = new DrivableArea(floor, clearance);
    drivable = area.among(boxes);
    seen = unpack(text);
  }

  /** These lie on the floor now, metres, map frame: they hide nothing, but are driven round. */
  void setBoxes(List<Vec2> lying) {
    if (!boxes.equals(lying)) {
      boxes = List.copyOf(lying);
      drivable = area.among(boxes);
      unseenBehindBoxes = null;
    }
  }

  /**
   * Looks all round: a cell is seen whose middle is in view, and which is within the range as a
   * whole.
   *
   * @param range metres that cameras see
   */
  void look(Vec2 from, double range) {
    seen.or(inView(from, range - walls.resolution() / Math.sqrt(2), unseen()));
  }

  /** What was seen counts no more: something is not where it was. */
  void forget() {
    seen.clear();
    givenUp.clear();
    unseenBehindBoxes = null;
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
   * @return the middle of a cell; empty: nothing more can be seen from anywhere, which is noted, or
   *     not until boxes are carried away
   */
  Optional<Vec2> nextView(Vec2 from, double range) {
    BitSet unseen = unseen();
    if (unseen.isEmpty() || unseen.equals(unseenBehindBoxes)) {
      return Optional.empty();
    }
    Optional<Vec2> view = nearestView(from, range, unseen);
    if (view.isPresent()) {
      return view;
    }
    if (boxes.isEmpty()) {
      seen.or(unseen); // behind what nobody can drive round
    } else {
      unseenBehindBoxes = unseen;
    }
    return Optional.empty();
  }

  private Optional<Vec2> nearestView(Vec2 from, double range, BitSet unseen) {
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
    return Optional.empty();
  }

  /** Whether something unseen is to be seen from there. */
  boolean isView(Vec2 place, double range) {
    return isView(drivable.cellAt(place), unseen(), range * CERTAIN);
  }

  private boolean isView(Cell cell, BitSet unseen, double range) {
    return drivable.contains(cell)
        && drivable.isFree(cell)
        && !givenUp.get(drivable.index(cell))
        && !inView(drivable.centre(cell), range, unseen).isEmpty();
  }

  /** Those of some cells whose middle is in view. */
  private BitSet inView(Vec2 from, double range, BitSet cells) {
    BitSet inView = new BitSet();
    Cell middle = walls.cellAt(from);
    int reach = (int) Math.ceil(range / walls.resolution());
    for (int row = middle.row() - reach; row <= middle.row() + reach; row++) {
      for (int column = middle.column() - reach; column <= middle.column() + reach; column++) {
        if (walls.contains(column, row) && cells.get(row * walls.width() + column)) {
          Vec2 way = walls.centre(new Cell(column, row)).minus(from);
          double metres = way.norm();
          if (metres <= range
              && RayCast.distance(walls, from, way.angle(), metres) >= metres - 1e-9) {
            inView.set(row * walls.width() + column);
          }
        }
      }
    }
    return inView;
  }

  /** From that place nothing more can be seen; from others it may. */
  void giveUp(Vec2 view) {
    givenUp.set(drivable.index(drivable.cellAt(view)));
    unseenBehindBoxes = null;
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
      return text.length() > LONGEST_TEXT ? "" : geometry() + text;
    } finally {
      deflater.end();
    }
  }

  /** Which cells these are: of a map of another size or elsewhere nothing is kept. */
  private String geometry() {
    return walls.width()
        + "x"
        + walls.height()
        + " of "
        + walls.resolution()
        + " at "
        + walls.origin().x()
        + ","
        + walls.origin().y()
        + ": ";
  }

  /** What is a wall now is none of them. */
  private BitSet unpack(@Nullable String text) {
    if (text == null || !text.startsWith(geometry())) {
      return new BitSet();
    }
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(Base64.getDecoder().decode(text.substring(geometry().length())));
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
