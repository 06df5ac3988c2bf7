package org.toqa.traffic.mapf;

import java.util.List;
import org.toqa.grid.Cell;
import org.toqa.traffic.RoadGraph;

/** Robots that are somewhere and want to be elsewhere, in a fixed order. */
public record MapfInstance(RoadGraph roads, List<Cell> starts, List<Cell> goals) {

  /**
   * @throws IllegalArgumentException if there are not as many goals as starts
   */
  public MapfInstance {
    starts = List.copyOf(starts);
    goals = List.copyOf(goals);
    if (starts.size() != goals.size()) {
      throw new IllegalArgumentException(
          "Every robot needs a start and a goal, but there are "
              + starts.size()
              + " starts and "
              + goals.size()
              + " goals.");
    }
  }

  public int robotCount() {
    return starts.size();
  }
}
