package org.toqa.planning;

import java.util.Arrays;
import org.toqa.grid.OccupancyGrid;

/**
 * The occupied cells of a grid, line by line as bits, with an occupied border: 64 cells are looked
 * at in a few instructions (Harabor and Grastien, "Improving jump point search", 2014, "Block-based
 * scanning"). A line is a row, or a column of the transposed picture. Immutable.
 *
 * <p>A straight run ends at the first occupied cell, or before it at a jump point: a cell with a
 * free cell beside it where the run's cell before had an occupied one. There, and only there, may a
 * shortest way leave the run that could not have left it earlier.
 */
final class BlockedLines {
  /** Words from one line to the next. */
  private final int stride;

  /** Line l begins at {@code 1 + (l + 1) stride}, position p is its bit p + 1; 1 is occupied. */
  private final long[] words;

  private BlockedLines(int lines, int length) {
    stride = (length + 2 + Long.SIZE - 1) / Long.SIZE;
    words = new long[(lines + 2) * stride + 2];
    Arrays.fill(words, -1);
  }

  /** By row; positions are columns. */
  static BlockedLines rows(OccupancyGrid grid) {
    BlockedLines rows = new BlockedLines(grid.height(), grid.width());
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        if (grid.isFree(column, row)) {
          rows.free(row, column);
        }
      }
    }
    return rows;
  }

  /** By column; positions are rows. */
  static BlockedLines columns(OccupancyGrid grid) {
    BlockedLines columns = new BlockedLines(grid.width(), grid.height());
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        if (grid.isFree(column, row)) {
          columns.free(column, row);
        }
      }
    }
    return columns;
  }

  private void free(int line, int position) {
    words[firstWord(line) + (position + 1) / Long.SIZE] &= ~(1L << (position + 1));
  }

  private int firstWord(int line) {
    return 1 + (line + 1) * stride;
  }

  /**
   * Runs from a free cell to higher positions.
   *
   * @return the jump point's position; or where an obstacle ends the run, as {@link #isDeadEnd}
   *     tells, the obstacle's one in a form that {@link #end} reads
   */
  int forward(int line, int position) {
    int first = firstWord(line);
    int word = first + (position + 1) / Long.SIZE;
    long ahead = -2L << (position + 1);
    while (true) {
      long own = words[word];
      long opens =
          opensForward(words[word - stride], words[word - stride - 1])
              | opensForward(words[word + stride], words[word + stride - 1]);
      long stops = (own | opens) & ahead;
      if (stops != 0) {
        int bit = Long.numberOfTrailingZeros(stops);
        return answer((word - first) * Long.SIZE + bit - 1, own >>> bit);
      }
      ahead = -1;
      word++;
    }
  }

  /** The same to lower positions. */
  int backward(int line, int position) {
    int first = firstWord(line);
    int word = first + (position + 1) / Long.SIZE;
    long ahead = (1L << (position + 1)) - 1;
    while (true) {
      long own = words[word];
      long opens =
          opensBackward(words[word - stride], words[word - stride + 1])
              | opensBackward(words[word + stride], words[word + stride + 1]);
      long stops = (own | opens) & ahead;
      if (stops != 0) {
        int bit = Long.SIZE - 1 - Long.numberOfLeadingZeros(stops);
        return answer((word - first) * Long.SIZE + bit - 1, own >>> bit);
      }
      ahead = -1;
      word--;
    }
  }

  /** Free cells whose neighbour at the next lower position is occupied. */
  private static long opensForward(long beside, long wordBefore) {
    return (beside << 1 | wordBefore >>> (Long.SIZE - 1)) & ~beside;
  }

  /** Free cells whose neighbour at the next higher position is occupied. */
  private static long opensBackward(long beside, long wordAfter) {
    return (beside >>> 1 | wordAfter << (Long.SIZE - 1)) & ~beside;
  }

  private static int answer(int position, long occupied) {
    return (occupied & 1) == 0 ? position : ~(position + 1);
  }

  /** Whether a run ended without a jump point. */
  static boolean isDeadEnd(int answer) {
    return answer < 0;
  }

  /** The position where a run ended: the jump point or the obstacle, -1 for the border. */
  static int end(int answer) {
    return answer < 0 ? ~answer - 1 : answer;
  }
}
