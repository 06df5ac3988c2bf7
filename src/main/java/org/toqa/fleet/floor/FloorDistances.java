package org.toqa.fleet.floor;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
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
  /** Of all the fields that are kept: 64 MB. */
  private static final int CELLS_KEPT = 16_000_000;

  private final OccupancyGrid grid;
  private final BySize<OccupancyGrid> passable = new BySize<>();
  private final Map<Key, DistanceField> fields;

  private record Key(Cell cell, double diameter) {}

  public FloorDistances(OccupancyGrid grid) {
    this.grid = grid;
    int most = Math.max(16, CELLS_KEPT / (grid.width() * grid.height()));
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
  public ToDoubleFunction<Vec2> lengthsFrom(Vec2 place, double diameter) {
    DistanceField field =
        fields.computeIfAbsent(
            new Key(grid.cellAt(place), diameter),
            key -> new DistanceField(passable(diameter), key.cell()));
    return other -> length(field, grid.cellAt(other)) * grid.resolution();
  }

  private OccupancyGrid passable(double diameter) {
    return passable.get(diameter, d -> Inflation.inflateWhereNothingFits(grid, d / 2));
  }

  /**
   * A robot may be stopped a little nearer to a wall than it would drive: a cell beside it will do.
   */
  private static double length(DistanceField field, Cell to) {
    double length = field.to(to);
    for (int dRow = -1; dRow <= 1 && Double.isInfinite(length); dRow++) {
      for (int dColumn = -1; dColumn <= 1; dColumn++) {
        length = Math.min(length, field.to(new Cell(to.column() + dColumn, to.row() + dRow)) + 1);
      }
    }
    return length;
  }
}
