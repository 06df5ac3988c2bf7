package org.toqa.traffic.lifelong;

import java.util.BitSet;
import java.util.List;
import org.toqa.traffic.RoadGraph;

/**
 * A floor at one moment.
 *
 * @param roads the cells that may be driven at present: not those of walls, obstacles, and robots
 *     that cannot move; the same object as long as nothing about them changes
 * @param robots each name once
 * @param closed the edges of the roads that nobody may drive now, as {@code vertex *
 *     RoadGraph.DIRECTIONS + direction}; unlike roads they change from plan to plan at no cost; not
 *     to be changed
 * @param steps how many steps of time have passed since the snapshot before, 0 or more
 */
public record TrafficSnapshot(
    RoadGraph roads, List<PlannedRobot> robots, BitSet closed, int steps) {
  public TrafficSnapshot {
    robots = List.copyOf(robots);
  }

  /** All roads are open, and a step has passed. */
  public TrafficSnapshot(RoadGraph roads, List<PlannedRobot> robots) {
    this(roads, robots, new BitSet(), 1);
  }
}
