package org.toqa.traffic.lifelong;

import java.util.List;
import org.toqa.traffic.RoadGraph;

/**
 * A floor at one moment.
 *
 * @param roads the cells that may be driven at present: not those of walls, obstacles, and robots
 *     that cannot move; the same object as long as nothing about them changes
 * @param robots each name once
 */
public record TrafficSnapshot(RoadGraph roads, List<PlannedRobot> robots) {
  public TrafficSnapshot {
    robots = List.copyOf(robots);
  }
}
