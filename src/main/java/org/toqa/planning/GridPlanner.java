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
 * What the planners on a grid have in common: the doors, and the last grid's search, kept for the
 * next plan on the same grid.
 */
abstract sealed class GridPlanner implements PathPlanner permits HeadingAStar, JumpPointSearch {
  private final Function<OccupancyGrid, GridSearch> layOut;
  private final LongConsumer effort;

  /** Empty while a thread searches: another one then lays out its own. */
  private final AtomicReference<@Nullable GridSearch> spare = new AtomicReference<>();

  /**
   * @param effort is told after each search how many states it has expanded
   */
  GridPlanner(Function<OccupancyGrid, GridSearch> layOut, LongConsumer effort) {
    this.layOut = layOut;
    this.effort = effort;
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
    long before = search.expanded();
    Optional<Path> way = search.way(start, goal);
    effort.accept(search.expanded() - before);
    spare.set(search);
    return way.<PlanResult>map(Found::new).orElseGet(() -> new NotFound(Reason.NO_PATH, goal));
  }

  private GridSearch searchOn(OccupancyGrid grid) {
    GridSearch search = spare.getAndSet(null);
    return search != null && search.grid().equals(grid) ? search : layOut.apply(grid);
  }
}
