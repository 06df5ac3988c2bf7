package org.toqa.planning.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.Scenes.Query;

class DiscSpacePropertyTest {
  @Provide
  Arbitrary<Query> queries() {
    return Scenes.queries();
  }

  @Property(edgeCases = EdgeCasesMode.NONE)
  void linesAreFreeJustWhereTheyAreFarEnoughFromEachSquare(@ForAll("queries") Query query) {
    double clearance = Scenes.clearance(query.grid(), query.from(), query.to());
    double rounding = 1e-8 * query.grid().resolution();
    if (Math.abs(clearance - query.radius()) > 2 * rounding) {
      assertEquals(
          clearance > query.radius(),
          DiscSpace.of(query.grid(), query.radius()).isFree(query.from(), query.to()));
    } else if (clearance >= query.radius() - rounding / 100) {
      assertEquals(
          true, DiscSpace.of(query.grid(), query.radius()).isFree(query.from(), query.to()));
    }
  }

  @Property(edgeCases = EdgeCasesMode.NONE)
  void distancesAreThoseToTheNearestSquareUpToTheHorizon(@ForAll("queries") Query query) {
    DiscSpace space = DiscSpace.of(query.grid(), query.radius());
    double expected =
        Scenes.clearance(query.grid(), query.from(), query.from()) / query.grid().resolution();
    double told =
        space.distance(space.toCellsX(query.from().x()), space.toCellsY(query.from().y()));
    double horizon = 2 * query.radius() / query.grid().resolution();
    if (expected < horizon) {
      assertEquals(expected, told, 1e-9);
    } else {
      assertEquals(true, told >= horizon - 1e-9);
    }
  }

  @Test
  void aDiscHasARadius() {
    OccupancyGrid grid = OccupancyGrid.parse("...");
    assertThrows(IllegalArgumentException.class, () -> DiscSpace.of(grid, 0));
    assertThrows(IllegalArgumentException.class, () -> DiscSpace.of(grid, Double.NaN));
  }

  @Test
  void anAisleThatJustFitsIsFreeAndOneThatIsNarrowerIsNot() {
    OccupancyGrid grid = OccupancyGrid.parse("@@@", "...", "@@@");
    Vec2 west = new Vec2(0.5, 1.5);
    Vec2 east = new Vec2(2.5, 1.5);
    assertEquals(true, DiscSpace.of(grid, 0.5).isFree(west, east));
    assertEquals(false, DiscSpace.of(grid, 0.5 + 1e-8).isFree(west, east));
  }
}
