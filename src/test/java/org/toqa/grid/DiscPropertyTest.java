package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Vec2;

class DiscPropertyTest {
  private static final OccupancyGrid FLOOR =
      new OccupancyGrid(20, 20, 0.3, Vec2.ZERO, new BitSet());

  @Property
  void cellsAlongALineAreThoseOfItsPoints(
      @ForAll @DoubleRange(min = -1, max = 7) double x1,
      @ForAll @DoubleRange(min = -1, max = 7) double y1,
      @ForAll @DoubleRange(min = -1, max = 7) double x2,
      @ForAll @DoubleRange(min = -1, max = 7) double y2,
      @ForAll @DoubleRange(min = 0.02, max = 0.8) double radius) {
    Vec2 from = new Vec2(x1, y1);
    Vec2 to = new Vec2(x2, y2);
    Set<Cell> swept = new HashSet<>(new Disc(radius).cellsAlong(FLOOR, from, to));
    Set<Cell> inner = new HashSet<>();
    Set<Cell> outer = new HashSet<>();
    int samples = 400;
    double step = from.distanceTo(to) / samples;
    for (int i = 0; i <= samples; i++) {
      Vec2 p = from.plus(to.minus(from).times((double) i / samples));
      inner.addAll(new Disc(radius).cellsAt(FLOOR, p));
      outer.addAll(new Disc(radius + step + 1e-6).cellsAt(FLOOR, p));
    }
    assertTrue(swept.containsAll(inner));
    assertTrue(outer.containsAll(swept));
  }

  @Example
  void robotInTheMiddleOfACellTouchesThatCellOnly() {
    Cell cell = new Cell(4, 5);
    Disc robot = new Disc(0.1275);
    assertEquals(List.of(cell), robot.cellsAt(FLOOR, FLOOR.centre(cell)));
  }

  @Example
  void diagonalMoveSweepsBothSideCells() {
    Disc robot = new Disc(0.1275);
    Set<Cell> swept =
        new HashSet<>(
            robot.cellsAlong(FLOOR, FLOOR.centre(new Cell(4, 5)), FLOOR.centre(new Cell(5, 4))));
    assertEquals(Set.of(new Cell(4, 5), new Cell(5, 4), new Cell(5, 5), new Cell(4, 4)), swept);
  }
}
