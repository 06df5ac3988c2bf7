package org.toqa.planning;

import java.util.Optional;
import java.util.concurrent.BlockingDeque;
import java.util.concurrent.LinkedBlockingDeque;
import java.util.function.Function;
import java.util.function.LongConsumer;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import org.toqa.planning.PlanResult.Reason;

/**
 * What the planners on a grid have in common: the checks of start and goal, and their searches,
 * kept with what they have looked up of the last grids. Whoever plans many paths keeps the planner.
 *
 * <p>Any number of threads may plan at once. Each takes an idle search out and puts it back; where
 * none is idle it makes one. So nothing is shared while it is used, as many searches stay as there
 * are processors, and each of them looks its grids up once.
 */
public abstract sealed class GridPlanner implements PathPlanner
    permits HeadingAStar, JumpPointSearch {
  private final Function<OccupancyGrid, GridSearch> searchFactory;
  private final LongConsumer expandedListener;

  /** The one that was used last is the first. */
  private final BlockingDeque<GridSearch> idleSearches =
      new LinkedBlockingDeque<>(Runtime.getRuntime().availableProcessors());

  /**
   * @param expandedListener is told after each search how many states it has expanded
   */
  GridPlanner(Function<OccupancyGrid, GridSearch> searchFactory, LongConsumer expandedListener) {
    this.searchFactory = searchFactory;
    this.expandedListener = expandedListener;
  }

  @Override
  public final PlanResult plan(OccupancyGrid grid, Cell start, Cell goal) {
    if (!grid.isFree(start)) {
      return new NotFound(Reason.START_BLOCKED, start);
    }
    if (!grid.isFree(goal)) {
      return new NotFound(Reason.GOAL_BLOCKED, goal);
    }
    if (start.equals(goal)) {
      return new Found(Path.of(start, new MoveSequence(), false));
    }
    GridSearch idle = idleSearches.pollFirst();
    GridSearch search = idle == null ? searchFactory.apply(grid) : idle;
    try {
      long before = search.expandedCount();
      Optional<Path> path = search.path(grid, start, goal);
      expandedListener.accept(search.expandedCount() - before);
      return path.<PlanResult>map(Found::new).orElseGet(() -> new NotFound(Reason.NO_PATH, goal));
    } finally {
      idleSearches.offerFirst(search); // one too many is dropped
    }
  }
}
