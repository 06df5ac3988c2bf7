package org.toqa.traffic.mapf;

import java.util.Arrays;
import org.toqa.grid.Cell;
import org.toqa.traffic.RoadGraph;

/**
 * Where each robot is at each step: a robot a path, in the order of the instance. Whoever has
 * arrived stays. Immutable.
 */
public final class MapfPlan {
  private final RoadGraph roads;
  private final int[][] paths;

  MapfPlan(RoadGraph roads, int[][] paths) {
    this.roads = roads;
    this.paths = paths.clone();
  }

  public int robotCount() {
    return paths.length;
  }

  /** The step, from 0, at which the last robot arrives. */
  public int makespan() {
    return Arrays.stream(paths).mapToInt(path -> path.length - 1).max().orElse(0);
  }

  /**
   * The robot's place at a step; its goal from the arrival on.
   *
   * @param robot by its place in the instance, from 0
   * @param step from 0
   */
  public Cell at(int robot, int step) {
    return roads.cell(VertexPaths.at(paths[robot], step));
  }

  /** The steps at which the robots arrive, summed. */
  public long sumOfCosts() {
    return VertexPaths.sumOfCosts(paths);
  }
}
