package org.toqa.traffic.lifelong;

import java.util.List;

/**
 * The next steps of all robots, driven together without collision; after them every robot can stay
 * where it is then.
 *
 * @param paths in the order of the snapshot's robots
 */
public record LifelongPlan(List<PlannedPath> paths) {
  public LifelongPlan {
    paths = List.copyOf(paths);
  }

  public PlannedPath path(int robot) {
    return paths.get(robot);
  }
}
