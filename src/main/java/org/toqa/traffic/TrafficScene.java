package org.toqa.traffic;

import java.util.List;

/**
 * A floor at one moment.
 *
 * @param roads the cells that may be driven at present: not those of walls, obstacles, and robots
 *     that cannot move; the same object as long as nothing about them changes
 * @param robots each name once
 */
public record TrafficScene(RoadGraph roads, List<TrafficRobot> robots) {
  public TrafficScene {
    robots = List.copyOf(robots);
  }
}
