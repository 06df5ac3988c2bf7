package org.toqa.fleet.floor;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.function.ToDoubleFunction;
import org.toqa.allocation.PathLengths;
import org.toqa.geometry.Vec2;
import org.toqa.grid.BySize;
import org.toqa.grid.Cell;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.DistanceField;

/**
 * The lengths of paths on a floor by its map: the planner's distances, one field for each place and
 * size of robot, the last ones kept. Any thread may ask.
 */
public final class FloorDistances implements PathLengths {
  /** Of all the fields that are kept, 64 MB; but sixteen fields on any floor. */
  private static final int CELLS_KEPT = 16_000_000;

  /** A field of no more cells is found within a tenth of a floor's tick. */
  private static final int CELLS_AT_ONCE = 100_000;

  private final OccupancyGrid grid;
  private final BySize<OccupancyGrid> passable = new BySize<>();
  private final Map<Key, DistanceField> fields;

  /** Those that are looked for by {@link #withoutWaiting}. */
  private final Set<Key> soughtFields = ConcurrentHashMap.newKeySet();

  private record Key(Cell cell, double diameter) {}

  public FloorDistances(OccupancyGrid grid) {
    this.grid = grid;
    int most = placesKept(grid);
    fields =
        Collections.synchronizedMap(
            new LinkedHashMap<>(16, 0.75f, true) {
              private static final long serialVersionUID = 1;

              @Override
              protected boolean removeEldestEntry(Map.Entry<Key, DistanceField> eldest) {
                return size() > most;
              }
            });
  }

  @Override
  public ToDoubleFunction<Vec2> lengthsTo(Vec2 place, double diameter) {
    Key key = new Key(grid.cellAt(place), diameter);
    DistanceField known = fields.get(key);
    return known == null ? lengths(findField(key)) : lengths(known);
  }

  @Override
  public double length(Vec2 from, Vec2 to, double diameter) {
    return grid.rules().isDirected()
        ? lengthsTo(to, diameter).applyAsDouble(from)
        : lengthsTo(from, diameter).applyAsDouble(to); // the same, and more often known
  }

  /**
   * A shortest path by the map as the corners of its line, metres, map frame; it goes straight on
   * where it can. Empty where there is none that is wide enough.
   */
  public List<Vec2> path(Vec2 from, Vec2 to, double diameter) {
    Key key = new Key(grid.cellAt(to), diameter);
    DistanceField known = fields.get(key);
    return new FieldPath(grid, known == null ? findField(key) : known).from(from, to);
  }

  /** How many places of one size lengths are kept for. */
  public int placesKept() {
    return placesKept(grid);
  }

  private static int placesKept(OccupancyGrid grid) {
    return Math.max(16, CELLS_KEPT / (grid.width() * grid.height()));
  }

  /**
   * The same for an agent: on a large floor lengths that are not known yet are those of straight
   * lines, until the executor has found them.
   */
  PathLengths withoutWaiting(Executor executor) {
    if (grid.width() * grid.height() <= CELLS_AT_ONCE) {
      return this;
    }
    return new PathLengths() {
      @Override
      public ToDoubleFunction<Vec2> lengthsTo(Vec2 place, double diameter) {
        return knownLengthsTo(place, diameter, executor);
      }

      @Override
      public double length(Vec2 from, Vec2 to, double diameter) {
        return grid.rules().isDirected()
            ? lengthsTo(to, diameter).applyAsDouble(from)
            : lengthsTo(from, diameter).applyAsDouble(to);
      }
    };
  }

  private ToDoubleFunction<Vec2> knownLengthsTo(Vec2 place, double diameter, Executor executor) {
    Key key = new Key(grid.cellAt(place), diameter);
    DistanceField known = fields.get(key);
    if (known != null) {
      return lengths(known);
    }
    if (soughtFields.add(key)) {
      executor.execute(() -> findSoughtField(key));
    }
    return place::distanceTo;
  }

  private void findSoughtField(Key key) {
    try {
      findField(key);
    } finally {
      soughtFields.remove(key);
    }
  }

  /** Nobody who asks for another one waits for it. */
  private DistanceField findField(Key key) {
    OccupancyGrid free = passable(key.diameter());
    DistanceField field = new DistanceField(free, target(free, key.cell()));
    fields.put(key, field);
    return field;
  }

  /**
   * Where paths lead to a cell: on a floor with one-way areas beside it, where it is too narrow.
   */
  private static Cell target(OccupancyGrid free, Cell cell) {
    return free.rules().isDirected() && !free.isFree(cell)
        ? free.cellsAround(free.centre(cell), 1).stream()
            .filter(free::isFree)
            .findFirst()
            .orElse(cell)
        : cell;
  }

  private ToDoubleFunction<Vec2> lengths(DistanceField field) {
    return other -> length(field, grid.cellAt(other)) * grid.resolution();
  }

  private OccupancyGrid passable(double diameter) {
    return passable.get(diameter, d -> Inflation.inflateWhereNothingFits(grid, d / 2));
  }

  /**
   * A robot may be stopped a little nearer to a wall than it would drive: a cell beside it will do.
   */
  private static double length(DistanceField field, Cell cell) {
    double length = field.from(cell);
    for (int dRow = -1; dRow <= 1 && Double.isInfinite(length); dRow++) {
      for (int dColumn = -1; dColumn <= 1; dColumn++) {
        length =
            Math.min(length, field.from(new Cell(cell.column() + dColumn, cell.row() + dRow)) + 1);
      }
    }
    return length;
  }
}
