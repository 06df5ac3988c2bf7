package org.toqa.planning;

import java.util.Arrays;
import org.toqa.grid.OccupancyGrid;

/**
 * Where straight runs over a grid end, line by line as bits: 64 cells are looked through in a few
 * instructions (Harabor and Grastien, "Improving jump point search", 2014, "Block-based scanning").
 * A line is a row, or a column, and a position counts along it. Confined to one thread at a time.
 *
 * <p>A run ends at the first occupied cell, or before it at a jump point: a free cell with a free
 * cell beside it where the run's cell before had an occupied one. There, and only there, may a
 * shortest path leave the run that could not have left it earlier.
 */
final class StraightRuns {
  /** Words from one line to the next; there is an occupied border of one cell. */
  private final int stride;

  /** Line l begins at {@code (l + 1) stride}, position p is its bit p + 1; 1 is occupied. */
  private final long[] occupied;

  /** Laid out alike; 1 where a run to higher positions ends. */
  private final long[] forwardEnds;

  /** And to lower positions. */
  private final long[] backwardEnds;

  private StraightRuns(int lines, int positions) {
    stride = (positions + 2 + Long.SIZE - 1) / Long.SIZE;
    occupied = new long[(lines + 2) * stride];
    Arrays.fill(occupied, -1);
    forwardEnds = new long[occupied.length];
    backwardEnds = new long[occupied.length];
  }

  /** Lines are rows, positions are columns. */
  static StraightRuns alongRows(OccupancyGrid grid) {
    StraightRuns runs = new StraightRuns(grid.height(), grid.width());
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        if (grid.isFree(column, row)) {
          runs.occupied[runs.word(row, column)] &= ~(1L << (column + 1));
        }
      }
    }
    runs.findEnds();
    return runs;
  }

  /** Lines are columns, positions are rows. */
  static StraightRuns alongColumns(OccupancyGrid grid) {
    StraightRuns runs = new StraightRuns(grid.width(), grid.height());
    for (int column = 0; column < grid.width(); column++) {
      for (int row = 0; row < grid.height(); row++) {
        if (grid.isFree(column, row)) {
          runs.occupied[runs.word(column, row)] &= ~(1L << (row + 1));
        }
      }
    }
    runs.findEnds();
    return runs;
  }

  private void findEnds() {
    for (int word = 0; word < occupied.length; word++) {
      findEnds(word);
    }
  }

  /** Makes an occupied cell free, or the other way round. */
  void flip(int line, int position) {
    int flipped = word(line, position);
    occupied[flipped] ^= 1L << (position + 1);
    for (int row = flipped - stride; row <= flipped + stride; row += stride) {
      for (int word = Math.max(0, row - 1); word <= row + 1 && word < occupied.length; word++) {
        findEnds(word);
      }
    }
  }

  private void findEnds(int word) {
    forwardEnds[word] = occupied[word];
    backwardEnds[word] = occupied[word];
    if (word >= stride && word < occupied.length - stride) { // no run goes along the border
      forwardEnds[word] |= opensForward(word - stride) | opensForward(word + stride);
      backwardEnds[word] |= opensBackward(word - stride) | opensBackward(word + stride);
    }
  }

  /** Free cells whose neighbour at the next lower position is occupied. */
  private long opensForward(int word) {
    long before = word == 0 ? -1 : occupied[word - 1];
    return (occupied[word] << 1 | before >>> (Long.SIZE - 1)) & ~occupied[word];
  }

  /** Free cells whose neighbour at the next higher position is occupied. */
  private long opensBackward(int word) {
    long after = word == occupied.length - 1 ? -1 : occupied[word + 1];
    return (occupied[word] >>> 1 | after << (Long.SIZE - 1)) & ~occupied[word];
  }

  private int word(int line, int position) {
    return (line + 1) * stride + (position + 1) / Long.SIZE;
  }

  /** The position where a run from a free cell to higher positions ends. */
  int forwardEnd(int line, int position) {
    int word = word(line, position);
    long ends = forwardEnds[word] & -2L << (position + 1);
    while (ends == 0) {
      ends = forwardEnds[++word];
    }
    return position(line, word, Long.numberOfTrailingZeros(ends));
  }

  /** The position where a run from a free cell to lower positions ends; -1 for the border. */
  int backwardEnd(int line, int position) {
    int word = word(line, position);
    long ends = backwardEnds[word] & (1L << (position + 1)) - 1;
    while (ends == 0) {
      ends = backwardEnds[--word];
    }
    return position(line, word, Long.SIZE - 1 - Long.numberOfLeadingZeros(ends));
  }

  private int position(int line, int word, int bit) {
    return (word - (line + 1) * stride) * Long.SIZE + bit - 1;
  }

  /** Whether a cell is free; the border's positions are not. */
  boolean isFree(int line, int position) {
    return (occupied[word(line, position)] >>> (position + 1) & 1) == 0;
  }
}
