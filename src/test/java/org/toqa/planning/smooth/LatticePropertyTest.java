package org.toqa.planning.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.Scenes.Query;
import org.toqa.planning.smooth.SmoothResult.Found;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

class LatticePropertyTest {
  /** Aisles of two cells, as wide as a disc of radius 1. */
  private static final OccupancyGrid AISLES =
      OccupancyGrid.parse(
          ".....@..", //
          ".....@..",
          "..@..@..",
          "..@..@..",
          "..@.....",
          "..@.....");

  private static final Vec2 SOUTH_WEST = new Vec2(1, 1);
  private static final Vec2 NORTH_EAST = new Vec2(7, 5);

  @Provide
  Arbitrary<Query> queries() {
    return Scenes.queries();
  }

  @Property(edgeCases = EdgeCasesMode.NONE)
  void itsPathsAreFree(@ForAll("queries") Query query) {
    DiscSpace space = DiscSpace.of(query.grid(), query.radius());
    if (space.isFree(query.from()) && space.isFree(query.to())) {
      WayPoints ends = new WayPoints();
      for (Vec2 end : new Vec2[] {query.from(), query.to()}) {
        ends.add(space.toCellsX(end.x()), space.toCellsY(end.y()));
      }
      WayPoints path = space.lattice().path(ends, () -> false);
      assertTrue(path == null || path.isFreeIn(space));
    }
  }

  @Test
  void aPathThroughAislesThatJustFitIsFoundAtOnceAndDrivenWithoutAStop() {
    DiscSpace space = DiscSpace.of(AISLES, 1);
    SmoothPlanner planner = new SmoothPlanner(SmoothMethod.HYBRID, 1);
    SmoothResult result = planner.plan(space, SOUTH_WEST, NORTH_EAST, PlanningBudget.iterations(1));
    WayPath path = assertInstanceOf(Found.class, result).path();
    assertTrue(Scenes.clearance(AISLES, path.points()) >= 1 - 1e-8);
    SmoothCurve curve = new SplineFitter(space).fit(path.points());
    assertEquals(1, curve.pieces().size());
  }
}
