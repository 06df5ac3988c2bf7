package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class AssignmentPropertyTest {

  @Property
  void isAsCheapAsTheCheapestOfAll(
      @ForAll long seed,
      @ForAll @IntRange(min = 1, max = 6) int rows,
      @ForAll @IntRange(min = 0, max = 2) int more,
      @ForAll @IntRange(min = 1, max = 100) int highest) {
    int columns = rows + more;
    // few different costs make ties, and negative ones are costs too
    double[] cost =
        new Random(seed).ints((long) rows * columns, -highest, highest).asDoubleStream().toArray();

    int[] columnOf = Assignment.leastCost(cost, rows);

    assertEquals(rows, Arrays.stream(columnOf).distinct().count());
    double sum = 0;
    for (int row = 0; row < rows; row++) {
      sum += cost[row * columns + columnOf[row]];
    }
    assertEquals(cheapest(cost, columns, 0, 0), sum, 1e-9);
  }

  /** Tries all. */
  private static double cheapest(double[] cost, int columns, int row, int taken) {
    if (row == cost.length / columns) {
      return 0;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int column = 0; column < columns; column++) {
      if ((taken & 1 << column) == 0) {
        double rest = cheapest(cost, columns, row + 1, taken | 1 << column);
        least = Math.min(least, cost[row * columns + column] + rest);
      }
    }
    return least;
  }

  @Example
  void nothingIsAssignedWhereThereIsNothing() {
    assertEquals(0, Assignment.leastCost(new double[0], 0).length);
  }

  @Example
  void moreRowsThanColumnsAreRefused() {
    assertThrows(
        IllegalArgumentException.class, () -> Assignment.leastCost(new double[] {1, 2}, 2));
  }
}
