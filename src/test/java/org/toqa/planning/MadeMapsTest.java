package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.PlanChecker.Rule;
import org.toqa.planning.PlanResult.Found;
import org.toqa.testbed.Tally;

/** Heading paths on caves, rooms and mazes are as short as {@link ReferenceSearch} finds them. */
class MadeMapsTest {
  private final Random random = new Random(20);

  private static Stream<Arguments> maps() {
    Random random = new Random(7);
    return Stream.of(
        Arguments.of("cave", MadeMaps.cave(100, 0.43, random), 100, 12),
        Arguments.of("rooms", MadeMaps.rooms(100, random), 100, 12),
        Arguments.of("maze of narrow corridors", MadeMaps.maze(100, 2, random), 100, 12),
        Arguments.of("maze of wide corridors", MadeMaps.maze(100, 8, random), 100, 12),
        Arguments.of("large cave", MadeMaps.cave(512, 0.43, random), 60, 3),
        Arguments.of("large rooms", MadeMaps.rooms(512, random), 60, 3),
        Arguments.of("large maze", MadeMaps.maze(512, 8, random), 20, 3));
  }

  /**
   * @param apart most columns and rows from start to goal
   */
  @ParameterizedTest(name = "{0}")
  @MethodSource("maps")
  void headingPathsAreShortest(String name, OccupancyGrid grid, int apart, int paths) {
    PathPlanner planner = new HeadingAStar();
    int found = 0;
    while (found < paths) {
      Cell start = grid.cell(random.nextInt(grid.width() * grid.height()));
      Cell goal =
          new Cell(
              start.column() + random.nextInt(-apart, apart + 1),
              start.row() + random.nextInt(-apart, apart + 1));
      if (grid.isFree(start) && grid.isFree(goal) && !start.equals(goal)) {
        found += assertShortest(planner, grid, start, goal) ? 1 : 0;
      }
    }
    Tally.add("paths of known length", found);
  }

  /** Whether there is a path at all. */
  private static boolean assertShortest(
      PathPlanner planner, OccupancyGrid grid, Cell start, Cell goal) {
    PlanResult result = planner.plan(grid, start, goal);
    OptionalDouble inArcs = ReferenceSearch.shortest(grid, start, goal, ReferenceSearch.ARCS_ONLY);
    OptionalDouble shortest =
        inArcs.isPresent()
            ? inArcs
            : ReferenceSearch.shortest(grid, start, goal, ReferenceSearch.ARCS_AND_SPOT_TURNS);
    if (shortest.isEmpty()) {
      assertInstanceOf(PlanResult.NotFound.class, result);
      return false;
    }
    Path path = assertInstanceOf(Found.class, result).path();
    String what = start + " to " + goal;
    assertEquals(shortest.getAsDouble(), path.cost(), 1e-6, what);
    assertTrue(inArcs.isEmpty() || path.turnsOnSpot() == 0, what);
    assertEquals(
        Optional.empty(), PlanChecker.violation(grid, start, goal, path, Rule.HEADING), what);
    return true;
  }
}
