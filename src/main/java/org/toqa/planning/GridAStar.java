package org.toqa.planning;

import java.util.List;
import java.util.function.LongConsumer;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import org.toqa.planning.PlanResult.Reason;

/** What the planners on a grid have in common: the doors, and the space they search in. */
abstract sealed class GridAStar implements PathPlanner permits OctileAStar, HeadingAStar {
  private final SearchSpace.Pool pool = new SearchSpace.Pool();
  private final LongConsumer effort;

  /**
   * @param effort is told after each search how many states it has expanded
   */
  GridAStar(LongConsumer effort) {
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
    SearchSpace space = pool.take(grid);
    long expanded = space.expanded();
    space.octile.begin(grid.index(goal), grid.index(start));
    PlanResult result =
        space.octile.distance(grid.index(start)) == OctileSearch.UNREACHABLE
            ? new NotFound(Reason.NO_PATH, goal)
            : new Found(search(space, start, goal));
    effort.accept(space.expanded() - expanded);
    pool.giveBack(space);
    return result;
  }

  /**
   * @param space its octile search has begun at the goal and reached the start
   */
  abstract Path search(SearchSpace space, Cell start, Cell goal);
}
