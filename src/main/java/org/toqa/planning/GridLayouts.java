package org.toqa.planning;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.OccupancyGrid;

/**
 * The layouts of the last grids. A floor's grids are few that stay, one for each size of robot, and
 * many that differ from one of these where an obstacle or another robot is: such a one is made from
 * the layout that is most like it, at a cost of the cells that differ and of one comparison of 64
 * cells at a time. Confined to one thread at a time.
 */
final class GridLayouts {
  /** Layouts are kept for so many cells, but for {@link #FEWEST} grids at least. */
  private static final int CELLS_KEPT = 1 << 22;

  private static final int FEWEST = 3;
  private static final int MOST = 8;

  /** A grid of which a larger part differs gets a layout of its own. */
  private static final int LARGEST_CHANGE = 64;

  /** That used last is the last one. */
  private final List<GridLayout> layouts = new ArrayList<>();

  private int built;

  /** That of a grid, valid until the next question. */
  GridLayout layout(OccupancyGrid grid) {
    GridLayout layout = find(grid);
    layouts.remove(layout);
    layouts.add(layout);
    int cells = grid.width() * grid.height();
    if (layouts.size() > Math.clamp(CELLS_KEPT / cells, FEWEST, MOST)) {
      layouts.removeFirst();
    }
    return layout;
  }

  private GridLayout find(OccupancyGrid grid) {
    for (GridLayout layout : layouts) {
      if (layout.grid().equals(grid)) {
        return layout;
      }
    }
    GridLayout nearest = null;
    BitSet least = new BitSet();
    int fewest = grid.width() * grid.height() / LARGEST_CHANGE + 1;
    for (GridLayout layout : layouts) {
      BitSet changed = changes(layout, grid);
      if (changed != null && changed.cardinality() < fewest) {
        nearest = layout;
        least = changed;
        fewest = changed.cardinality();
      }
    }
    if (nearest == null) {
      built++;
      return new GridLayout(grid);
    }
    nearest.update(grid, least);
    return nearest;
  }

  private static @Nullable BitSet changes(GridLayout layout, OccupancyGrid grid) {
    OccupancyGrid known = layout.grid();
    return known.width() == grid.width()
            && known.height() == grid.height()
            && known.rules().equals(grid.rules())
        ? known.differences(grid)
        : null;
  }

  /** How many layouts were found from nothing. */
  int builtCount() {
    return built;
  }
}
