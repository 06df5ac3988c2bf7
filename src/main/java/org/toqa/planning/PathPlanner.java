package org.toqa.planning;

import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Finds a path for one robot.
 *
 * <ol>
 *   <li>The caller inflates the grid by the robot's margin; a planner knows points only.
 *   <li>{@link #plan} answers a path from start to goal, or why there is none. It is a function of
 *       its arguments: no clock, no memory that a caller could notice.
 * </ol>
 *
 * Any thread may call it.
 */
public interface PathPlanner {

  /**
   * The shortest path by the planner's own measure.
   *
   * @param grid inflated; a blocked start or goal is an answer, not an error
   */
  PlanResult plan(OccupancyGrid grid, Cell start, Cell goal);
}
