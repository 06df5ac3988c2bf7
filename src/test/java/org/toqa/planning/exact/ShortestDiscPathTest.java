package org.toqa.planning.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.Scenes;
import org.toqa.planning.smooth.Scenes.Query;

class ShortestDiscPathTest {
  private static OptionalDouble length(OccupancyGrid grid, double radius, Vec2 from, Vec2 to) {
    return new ShortestDiscPath(grid, radius).length(from, to);
  }

  @Test
  void whereNothingIsBetweenItIsStraight() {
    OccupancyGrid grid = OccupancyGrid.parse("....", "....", "....");
    assertEquals(
        Math.hypot(2, 1), length(grid, 0.5, new Vec2(1, 1), new Vec2(3, 2)).orElseThrow(), 1e-12);
  }

  @Test
  void roundASquareItIsTwoTangentsTwoArcsAndAStraight() {
    // a square from (4, 2) to (5, 3), passed above; below there is no room
    OccupancyGrid grid =
        OccupancyGrid.parse(
            ".........", ".........", ".........", "....@....", "....@....", "....@....");
    double r = 0.5;
    // from (0.5, 2) to the circle about (4, 3): 3.5 to the east and 1 to the north
    double distance = Math.hypot(3.5, 1);
    double tangent = Math.sqrt(distance * distance - r * r);
    // the line rises by atan(1 / 3.5) + asin(r / distance), and so much is the first arc
    double angle = Math.atan2(1, 3.5) + Math.asin(r / distance);
    double expected = 2 * (tangent + r * angle) + 1;
    assertEquals(expected, length(grid, r, new Vec2(0.5, 2), new Vec2(8.5, 2)).orElseThrow(), 1e-9);
  }

  @Test
  void inAnAisleThatJustFitsItGoesRoundTheInnerCorner() {
    OccupancyGrid grid = OccupancyGrid.parse("@@@.", "@@@.", "@@@.", "....");
    // 2.5 m to below the corner at (3, 1), a quarter of a circle of 0.5 m, and 2.5 m on
    assertEquals(
        5 + Math.PI / 4,
        length(grid, 0.5, new Vec2(0.5, 0.5), new Vec2(3.5, 3.5)).orElseThrow(),
        1e-9);
    assertTrue(length(grid, 0.501, new Vec2(0.5, 0.5), new Vec2(3.5, 3.5)).isEmpty());
  }

  @Test
  void diagonalNeighboursAreClosed() {
    OccupancyGrid grid = OccupancyGrid.parse("..@", "..@", "@@.");
    assertTrue(length(grid, 0.1, new Vec2(0.5, 1.5), new Vec2(2.5, 0.5)).isEmpty());
  }

  @Provide
  Arbitrary<Query> queries() {
    return Scenes.queries();
  }

  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void itIsTheSameBackAndNeverShorterThanStraightOrForASmallerDisc(@ForAll("queries") Query query) {
    OptionalDouble there = length(query.grid(), query.radius(), query.from(), query.to());
    OptionalDouble back = length(query.grid(), query.radius(), query.to(), query.from());
    OptionalDouble smaller = length(query.grid(), 0.9 * query.radius(), query.from(), query.to());
    assertEquals(there.isPresent(), back.isPresent());
    if (there.isPresent()) {
      double rounding = 1e-7 * query.grid().resolution();
      assertEquals(there.getAsDouble(), back.getAsDouble(), rounding);
      assertTrue(there.getAsDouble() >= query.from().distanceTo(query.to()) - rounding);
      assertTrue(there.getAsDouble() >= smaller.orElseThrow() - rounding);
    }
  }
}
