package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.RandomGrids.Query;
import org.toqa.planning.SearchLimit.SearchTimeoutException;

/** A planner is kept and asked again and again, by any thread, and some searches are cut off. */
class PlannerReuseTest {
  private static final int QUERIES = 40;

  /** A step, its cell, and three times its place in a list. */
  private static final int BYTES_A_STEP = 100;

  private static final int BYTES_A_PATH = 1_000;

  private static List<Query> queries(OccupancyGrid grid, Random random) {
    List<Query> queries = new ArrayList<>();
    while (queries.size() < QUERIES) {
      Query query = RandomGrids.query(grid, random);
      if (grid.isFree(query.start()) && grid.isFree(query.goal())) {
        queries.add(query);
      }
    }
    return queries;
  }

  private static PlanResult plan(PathPlanner planner, Query query) {
    return planner.plan(query.grid(), query.start(), query.goal());
  }

  /** In the cave mostly by jump points alone, in the maze by headings. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void pathIsAllThatIsAllocated(boolean inMaze) {
    Random random = new Random(3);
    OccupancyGrid grid = inMaze ? MadeMaps.maze(150, 3, random) : MadeMaps.cave(150, 0.42, random);
    ThreadMXBean threads =
        assertInstanceOf(ThreadMXBean.class, ManagementFactory.getThreadMXBean());
    PathPlanner planner = new HeadingAStar();
    List<Query> queries = queries(grid, random);
    queries.forEach(query -> plan(planner, query)); // its room grows to what they need
    for (Query query : queries) {
      long before = threads.getCurrentThreadAllocatedBytes();
      PlanResult result = plan(planner, query);
      long allocated = threads.getCurrentThreadAllocatedBytes() - before;
      int steps = result instanceof Found(Path path) ? path.steps().size() : 0;
      assertTrue(
          allocated < BYTES_A_PATH + BYTES_A_STEP * steps,
          () -> allocated + " B for " + steps + " steps");
    }
  }

  @Test
  void pathWithoutSharpBendsIsFoundByJumpPointsAlone() {
    OccupancyGrid hall =
        OccupancyGrid.parse(
            "..........", //
            "..........",
            "...####...",
            "...####...",
            "..........",
            "..........");
    long[] expanded = new long[2];
    Cell start = new Cell(0, 5);
    Cell goal = new Cell(9, 0);
    Path octile =
        assertInstanceOf(
                Found.class,
                new JumpPointSearch(count -> expanded[0] = count).plan(hall, start, goal))
            .path();
    Path heading =
        assertInstanceOf(
                Found.class, new HeadingAStar(count -> expanded[1] = count).plan(hall, start, goal))
            .path();
    assertEquals(octile.cost(), heading.cost(), 1e-9);
    assertEquals(expanded[0], expanded[1]);
  }

  @Test
  void anyThreadMayPlan() throws Exception {
    Random random = new Random(4);
    OccupancyGrid first = MadeMaps.maze(60, 3, random);
    OccupancyGrid second = MadeMaps.cave(60, 0.42, random);
    List<Query> queries = queries(first, random);
    queries.addAll(queries(second, random));
    List<PlanResult> expected = queries.stream().map(q -> plan(new HeadingAStar(), q)).toList();
    PathPlanner shared = new HeadingAStar();
    Callable<List<PlanResult>> all = () -> queries.stream().map(q -> plan(shared, q)).toList();
    try (ExecutorService threads = Executors.newFixedThreadPool(4)) {
      for (Future<List<PlanResult>> answers :
          threads.invokeAll(List.of(all, all, all, all, all, all))) {
        assertEquals(expected, answers.get());
      }
    }
  }

  @Test
  void searchThatIsCutOffLeavesNothingBehind() {
    Random random = new Random(6);
    OccupancyGrid grid = MadeMaps.maze(200, 6, random);
    PathPlanner planner = new HeadingAStar();
    int cutOff = 0;
    for (Query query : queries(grid, random)) {
      PlanResult expected = plan(new HeadingAStar(), query);
      for (int checks = 0; checks < 40; checks += 1 + checks / 2) {
        cutOff += isCutOff(planner, query, checks) ? 1 : 0;
        assertEquals(expected, plan(planner, query));
      }
    }
    assertTrue(cutOff > QUERIES, "only " + cutOff + " were cut off");
  }

  private static boolean isCutOff(PathPlanner planner, Query query, int checks) {
    int[] left = {checks};
    try {
      SearchLimit.within(() -> left[0]-- <= 0, () -> plan(planner, query));
      return false;
    } catch (SearchTimeoutException timeout) {
      return true;
    }
  }
}
