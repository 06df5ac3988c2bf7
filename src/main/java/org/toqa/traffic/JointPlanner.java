package org.toqa.traffic;

import java.util.List;
import java.util.Optional;

/**
 * Plans the paths of many robots together, on cells, a step at a time: four neighbours or wait, no
 * two robots on a cell or on cells too near to each other, no swap, and no ring of robots that all
 * move at once, since on a floor each of them would wait for the next to leave. A function of its
 * arguments; any thread may call it.
 */
public interface JointPlanner {

  /**
   * @param spacing which vertices cannot be taken at once
   * @param starts a vertex a robot, all different
   * @param goals a vertex a robot, all different
   * @return the vertices of all robots after each step, the starts first; empty where there is no
   *     plan, or none was found in time
   */
  Optional<List<int[]>> plan(
      RoadGraph roads, Spacing spacing, int[] starts, int[] goals, Deadline deadline);
}
