package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.BitSet;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.RandomGrids.Query;

class GridLayoutsPropertyTest {

  @Provide
  Arbitrary<Query> strewn() {
    return RandomGrids.strewn(20, 80, 0.4, 1);
  }

  /** Here and there a cell is closed or opened, as where obstacles and robots come and go. */
  @Property(tries = 200)
  void layoutThatIsUpdatedIsLikeANewOne(@ForAll("strewn") Query query, @ForAll long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid = query.grid();
    GridLayouts layouts = new GridLayouts();
    layouts.layout(grid);
    for (int i = 0; i < 5; i++) {
      grid = withChanges(grid, 1 + grid.width() * grid.height() / 200, random);
      assertAlike(new GridLayout(grid), layouts.layout(grid), grid);
    }
    assertEquals(1, layouts.builtCount());
  }

  private static void assertAlike(GridLayout fresh, GridLayout updated, OccupancyGrid grid) {
    assertEquals(grid, updated.grid());
    for (int cell = 0; cell < grid.width() * grid.height(); cell++) {
      Cell at = grid.cell(cell);
      assertEquals(fresh.graph().moves(cell), updated.graph().moves(cell), at::toString);
      if (grid.isFree(at)) {
        assertRunsEnd(fresh.alongRows(), updated.alongRows(), at.row(), at.column());
        assertRunsEnd(fresh.alongColumns(), updated.alongColumns(), at.column(), at.row());
      }
    }
  }

  private static void assertRunsEnd(StraightRuns a, StraightRuns b, int line, int position) {
    assertEquals(a.forwardEnd(line, position), b.forwardEnd(line, position));
    assertEquals(a.backwardEnd(line, position), b.backwardEnd(line, position));
    assertEquals(a.isFree(line, position), b.isFree(line, position));
  }

  /** Among grids that differ a little and a lot, planners answer as if each were the first. */
  @Property(tries = 200)
  void plannersTellAlikeGridsApart(@ForAll("strewn") Query query, @ForAll long seed) {
    Random random = new Random(seed);
    OccupancyGrid walls = query.grid();
    OccupancyGrid inflated = withChanges(walls, walls.width() * walls.height() / 8, random);
    List<PathPlanner> kept = List.of(new HeadingAStar(), new JumpPointSearch());
    for (int i = 0; i < 6; i++) {
      OccupancyGrid base = random.nextBoolean() ? walls : inflated;
      OccupancyGrid grid = random.nextInt(3) == 0 ? base : withChanges(base, 3, random);
      List<PathPlanner> fresh = List.of(new HeadingAStar(), new JumpPointSearch());
      Cell goal = random.nextBoolean() ? query.goal() : query.start();
      Cell start = grid.cell(random.nextInt(grid.width() * grid.height()));
      for (int k = 0; k < kept.size(); k++) {
        assertEquals(fresh.get(k).plan(grid, start, goal), kept.get(k).plan(grid, start, goal));
      }
    }
  }

  private static OccupancyGrid withChanges(OccupancyGrid grid, int changes, Random random) {
    BitSet occupied = grid.occupied();
    for (int i = 0; i < changes; i++) {
      occupied.flip(random.nextInt(grid.width() * grid.height()));
    }
    return grid.withOccupied(occupied);
  }

  /** A floor's grids for two sizes of robot, in turn, with obstacles before each. */
  @Test
  void obstaclesBuildNoLayout() {
    Random random = new Random(5);
    OccupancyGrid narrow = new OccupancyGrid(300, 200, 0.1, Vec2.ZERO, new BitSet());
    OccupancyGrid wide = withChanges(narrow, 6_000, random);
    GridLayouts layouts = new GridLayouts();
    for (int i = 0; i < 50; i++) {
      layouts.layout(withChanges(narrow, 100, random));
      layouts.layout(withChanges(wide, 100, random));
    }
    assertEquals(2, layouts.builtCount());
  }
}
