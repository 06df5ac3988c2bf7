package org.toqa.fleet.floor;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;

/**
 * Missions by the robots that work for them; asking for a robot's costs the same however many there
 * are. Of several of one robot the one counts that came first.
 */
final class MissionIndex {
  private final Map<Long, Entry> byTask = new HashMap<>();

  /** By robot, the missions that it works for, by their numbers. */
  private final Map<String, TreeMap<Long, Mission>> byRobot = new HashMap<>();

  /** By robot, the one of those that counts: kept, since each tick asks for it many times. */
  private final Map<String, Optional<Mission>> first = new HashMap<>();

  private long lastNumber;

  /**
   * @param number counted in the order in which missions came
   */
  private record Entry(long number, Mission mission) {}

  /** Adds the mission, or replaces it as it was. */
  void put(Mission mission) {
    Entry before = byTask.get(mission.id());
    if (before != null) {
      removeFromRobots(before);
    }
    Entry next = new Entry(before == null ? ++lastNumber : before.number(), mission);
    byTask.put(mission.id(), next);
    for (String robot : robotsOf(mission)) {
      byRobot.computeIfAbsent(robot, _ -> new TreeMap<>()).put(next.number(), mission);
      updateFirst(robot);
    }
  }

  void remove(long task) {
    Entry before = byTask.remove(task);
    if (before != null) {
      removeFromRobots(before);
    }
  }

  private void removeFromRobots(Entry entry) {
    for (String robot : robotsOf(entry.mission())) {
      byRobot.computeIfPresent(
          robot,
          (_, missions) -> {
            missions.remove(entry.number());
            return missions.isEmpty() ? null : missions;
          });
      updateFirst(robot);
    }
  }

  private void updateFirst(String robot) {
    TreeMap<Long, Mission> missions = byRobot.get(robot);
    if (missions == null) {
      first.remove(robot);
    } else {
      first.put(robot, Optional.of(missions.firstEntry().getValue()));
    }
  }

  private static List<String> robotsOf(Mission mission) {
    return mission.assignedRobots().stream()
        .filter(assigned -> !assigned.unassigned())
        .map(AssignedRobot::robot)
        .toList();
  }

  /** The mission that the robot works for. */
  Optional<Mission> missionOf(String robot) {
    return first.getOrDefault(robot, Optional.empty());
  }
}
