package org.toqa.grid;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * A set of cells in few numbers, row by row from the top: index of the first cell ({@link
 * OccupancyGrid#index}), number of cells, and so on by turns. Immutable.
 */
public record CellRuns(List<Integer> runs) {

  public static final CellRuns NONE = new CellRuns(List.of());

  public CellRuns {
    runs = List.copyOf(runs);
  }

  /** The same set, bits by {@link OccupancyGrid#index}. */
  public BitSet cells() {
    BitSet cells = new BitSet();
    for (int i = 0; i + 1 < runs.size(); i += 2) {
      cells.set(runs.get(i), runs.get(i) + runs.get(i + 1));
    }
    return cells;
  }

  /**
   * The same set.
   *
   * @param cells bits by {@link OccupancyGrid#index}
   */
  public static CellRuns of(BitSet cells) {
    List<Integer> runs = new ArrayList<>();
    int from = cells.nextSetBit(0);
    while (from >= 0) {
      int to = cells.nextClearBit(from);
      runs.add(from);
      runs.add(to - from);
      from = cells.nextSetBit(to);
    }
    return new CellRuns(runs);
  }
}
