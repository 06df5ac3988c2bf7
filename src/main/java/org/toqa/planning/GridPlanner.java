package org.toqa.planning;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import org.toqa.planning.PlanResult.Reason;

/**
 * What the planners on a grid have in common: the checks of start and goal, and the last grid's
 * search, kept for the next plan on the same grid.
 */
public abstract sealed class GridPlanner implements PathPlanner
    permits HeadingAStar, JumpPointSearch {
  private final Function<OccupancyGrid, GridSearch> searchFactory;
  private final LongConsumer expandedListener;

  /** Empty while a thread searches: another one then lays out its own. */
  private final AtomicReference<@Nullable GridSearch> idleSearch = new AtomicReference<>();

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
      return new Found(Path.of(start, List.of(), false));
    }
    GridSearch search = searchOn(grid);
    long before = search.expandedCount();
    Optional<Path> path = search.path(start, goal);
    expandedListener.accept(search.expandedCount() - before);
    idleSearch.set(search);
    return path.<PlanResult>map(Found::new).orElseGet(() -> new NotFound(Reason.NO_PATH, goal));
  }

  private GridSearch searchOn(OccupancyGrid grid) {
    GridSearch search = idleSearch.getAndSet(null);
    return search != null && search.grid().equals(grid) ? search : searchFactory.apply(grid);
  }
}
