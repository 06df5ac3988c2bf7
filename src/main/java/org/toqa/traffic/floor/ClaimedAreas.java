package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What robots have or will need, while paths are planned: each robot's is read again only when its
 * path has become another. Confined to one thread.
 */
final class ClaimedAreas {
  private final Collection<TrafficRobot> robots;
  private final Map<TrafficRobot, Entry> byRobot = new HashMap<>();

  /** A robot's areas, as they were when it had changed so often. */
  private record Entry(long changes, int pathNumber, List<SweptArea> areas) {}

  /**
   * @param robots all; nobody but the planner changes them
   */
  ClaimedAreas(Collection<TrafficRobot> robots) {
    this.robots = robots;
  }

  /** In parts. */
  List<SweptArea> of(TrafficRobot robot) {
    Entry known = byRobot.get(robot);
    if (known == null
        || known.changes != robot.changes()
        || known.pathNumber != robot.drive.pathNumber()) {
      known = new Entry(robot.changes(), robot.drive.pathNumber(), List.copyOf(robot.claimed()));
      byRobot.put(robot, known);
    }
    return known.areas;
  }

  /** In parts: what others than a robot have or will need. */
  List<SweptArea> ofOthers(TrafficRobot robot) {
    List<SweptArea> areas = new ArrayList<>();
    for (TrafficRobot other : robots) {
      if (other != robot) {
        areas.addAll(of(other));
      }
    }
    return areas;
  }
}
