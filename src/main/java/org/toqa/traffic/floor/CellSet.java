package org.toqa.traffic.floor;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntConsumer;

/**
 * Some cells of a grid, by {@link org.toqa.grid.OccupancyGrid#index}. A robot touches a few cells
 * of a floor that may have a million, so they are listed, not marked. Immutable.
 */
final class CellSet {
  private final int[] indices;

  private CellSet(int[] indices) {
    this.indices = indices;
  }

  /** Of indices in any order, repeated or not. */
  static CellSet of(int[] some) {
    return new CellSet(Arrays.stream(some).sorted().distinct().toArray());
  }

  void forEach(IntConsumer consumer) {
    for (int index : indices) {
      consumer.accept(index);
    }
  }

  void addTo(BitSet cells) {
    for (int index : indices) {
      cells.set(index);
    }
  }

  boolean contains(int index) {
    return Arrays.binarySearch(indices, index) >= 0;
  }

  boolean intersects(BitSet cells) {
    return firstIn(cells) >= 0;
  }

  /** The first of these that is in the other set too, or -1. */
  int firstIn(BitSet cells) {
    for (int index : indices) {
      if (cells.get(index)) {
        return index;
      }
    }
    return -1;
  }
}
