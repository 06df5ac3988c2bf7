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
    robotsOf(mission)
        .forEach(
            robot ->
                byRobot.computeIfAbsent(robot, _ -> new TreeMap<>()).put(next.number(), mission));
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
    return Optional.ofNullable(byRobot.get(robot))
        .map(missions -> missions.firstEntry().getValue());
  }
}
