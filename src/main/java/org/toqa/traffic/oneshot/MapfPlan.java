package org.toqa.traffic.oneshot;

import java.util.Arrays;
import org.toqa.grid.Cell;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.route.Routes;

/**
 * Where each robot is at each step: a robot a route, in the order of the instance. Whoever has
 * arrived stays. Immutable.
 */
public final class MapfPlan {
  private final RoadGraph roads;
  private final int[][] routes;

  MapfPlan(RoadGraph roads, int[][] routes) {
    this.roads = roads;
    this.routes = routes.clone();
  }

  public int robots() {
    return routes.length;
  }

  /** The step at which the last robot arrives. */
  public int makespan() {
    return Arrays.stream(routes).mapToInt(route -> route.length - 1).max().orElse(0);
  }

  /** The robot's place at a step; its goal from the arrival on. */
  public Cell at(int robot, int step) {
    return roads.cell(Routes.at(routes[robot], step));
  }

  /** The arrivals of all robots, summed. */
  public long sumOfCosts() {
    return Routes.sumOfCosts(routes);
  }
}
