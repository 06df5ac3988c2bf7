package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.toqa.geometry.Vec2;

class InflationPropertyTest {

  @Property
  void cellIsBlockedExactlyWhereTheDiscDoesNotFit(
      @ForAll @IntRange(min = 1, max = 25) int width,
      @ForAll @IntRange(min = 1, max = 25) int height,
      @ForAll @DoubleRange(min = 0.01, max = 2) double radius,
      @ForAll long seed) {
    OccupancyGrid grid = random(width, height, new Random(seed));
    OccupancyGrid inflated = Inflation.inflate(grid, radius);
    Disc disc = new Disc(radius);
    for (int i = 0; i < width * height; i++) {
      Cell cell = grid.cell(i);
      assertEquals(disc.isFreeAt(grid, grid.centre(cell)), inflated.isFree(cell), cell.toString());
    }
  }

  @Property
  void onlyCellsInWhichTheDiscFitsNowhereAreBlocked(
      @ForAll @IntRange(min = 1, max = 25) int width,
      @ForAll @IntRange(min = 1, max = 25) int height,
      @ForAll @DoubleRange(min = 0.01, max = 2) double radius,
      @ForAll long seed) {
    OccupancyGrid grid = random(width, height, new Random(seed));
    OccupancyGrid nowhere = Inflation.inflateWhereNothingFits(grid, radius);
    Disc disc = new Disc(radius);
    for (int i = 0; i < width * height; i++) {
      Vec2 middle = grid.centre(grid.cell(i));
      boolean fits =
          IntStream.range(0, 9)
              .mapToObj(k -> middle.plus(new Vec2(k % 3 - 1, k / 3 - 1).times(0.15)))
              .anyMatch(point -> disc.isFreeAt(grid, point));
      assertEquals(fits, nowhere.isFree(grid.cell(i)), grid.cell(i).toString());
    }
  }

  private static OccupancyGrid random(int width, int height, Random random) {
    BitSet occupied = new BitSet();
    for (int i = 0; i < width * height; i++) {
      occupied.set(i, random.nextInt(20) == 0);
    }
    return new OccupancyGrid(width, height, 0.3, new Vec2(-3, 7), occupied);
  }

  @Example
  void anAisleOfTwoCellsHasAWayBetweenTheirMiddles() {
    OccupancyGrid aisle =
        new OccupancyGrid(
            4, 3, 0.3, Vec2.ZERO, OccupancyGrid.parse("#..#", "#..#", "#..#").occupied());
    assertFalse(Inflation.inflate(aisle, 0.25).isFree(1, 1));
    assertTrue(Inflation.inflateWhereNothingFits(aisle, 0.25).isFree(1, 1));
    assertFalse(Inflation.inflateWhereNothingFits(aisle, 0.31).isFree(1, 1));
  }

  @Example
  void robotFitsAnAisleOfOneCell() {
    OccupancyGrid aisle =
        new OccupancyGrid(
            3, 3, 0.3, Vec2.ZERO, OccupancyGrid.parse("#.#", "#.#", "#.#").occupied());
    assertEquals(aisle, Inflation.inflate(aisle, 0.255 / 2));
    assertEquals(aisle, Inflation.inflate(aisle, 0.15)); // as wide as the aisle: it only touches
    assertEquals(9, Inflation.inflate(aisle, 0.16).occupied().cardinality());
  }

  @Example
  void marginOfOneCellBlocksTheEightNeighboursAndTheBorder() {
    BitSet centre = new BitSet();
    centre.set(24);
    OccupancyGrid grid = new OccupancyGrid(7, 7, 0.3, Vec2.ZERO, centre);
    OccupancyGrid inflated = Inflation.inflate(grid, 0.3);
    assertFalse(inflated.isFree(2, 2)); // corner of the square is 0.21 m away
    assertFalse(inflated.isFree(0, 1));
    assertTrue(inflated.isFree(1, 3));
  }

  @Example
  void aMarginWiderThanTheMapBlocksAll() {
    OccupancyGrid grid = OccupancyGrid.parse("...", "...");
    assertEquals(6, Inflation.inflate(grid, 1e9).occupied().cardinality());
  }

  @Example
  void aMarginThatIsNoLengthIsRefused() {
    OccupancyGrid grid = OccupancyGrid.parse(".");
    assertThrows(IllegalArgumentException.class, () -> Inflation.inflate(grid, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> Inflation.inflate(grid, -0.1));
  }
}
