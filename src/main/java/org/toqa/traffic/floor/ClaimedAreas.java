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
  private record Entry(long changes, int pathNumber, List<SweptArea> areas, SweptArea whole) {}

  /**
   * @param robots all; nobody but the planner changes them
   */
  ClaimedAreas(Collection<TrafficRobot> robots) {
    this.robots = robots;
  }

  /** In parts. */
  List<SweptArea> of(TrafficRobot robot) {
    return entry(robot).areas;
  }

  /**
   * Whether who drives over an area comes too near to what another one has or will need.
   *
   * @param standing what it covers where it sets out
   */
  boolean isTooNear(TrafficRobot other, SweptArea standing, SweptArea area) {
    Entry its = entry(other);
    if (!its.whole.isInBox(area, Clearance.BETWEEN_ROBOTS)) {
      return false;
    }
    for (SweptArea there : its.areas) {
      if (!Clearance.isKept(standing, area, there)) {
        return true;
      }
    }
    return false;
  }

  private Entry entry(TrafficRobot robot) {
    Entry known = byRobot.get(robot);
    if (known == null
        || known.changes != robot.changes()
        || known.pathNumber != robot.drive.pathNumber()) {
      List<SweptArea> areas = List.copyOf(robot.claimed());
      known = new Entry(robot.changes(), robot.drive.pathNumber(), areas, SweptArea.union(areas));
      byRobot.put(robot, known);
    }
    return known;
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
