package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;

/**
 * A floor's missions that have not ended, those that ended since they were last told of, and what
 * of all that is stored. Confined to the floor's agent.
 */
final class OpenMissions {
  private final Map<Long, DatedMission> open = new LinkedHashMap<>();
  private final List<DatedMission> ended = new ArrayList<>();

  /** As they are in the store; those with robots only. */
  private final Map<Long, Mission> stored = new LinkedHashMap<>();

  /** Who works for which of the open ones; null after one of them has changed. */
  private @Nullable Map<String, Mission> byRobot;

  /** The same of the stored ones. */
  private @Nullable Map<String, Mission> storedByRobot;

  /** A mission, and when it last changed. */
  record DatedMission(Mission mission, Instant changedAt) {}

  void put(Mission mission, Instant at) {
    byRobot = null;
    if (mission.state().isEnded()) {
      open.remove(mission.id());
      ended.add(new DatedMission(mission, at));
    } else {
      open.put(mission.id(), new DatedMission(mission, at));
    }
  }

  /** The mission is so in the store. */
  void setStored(Mission mission) {
    storedByRobot = null;
    if (mission.state().isEnded() || mission.state() == TaskState.QUEUED) {
      stored.remove(mission.id());
    } else {
      stored.put(mission.id(), mission);
    }
  }

  void remove(long task) {
    byRobot = null;
    open.remove(task);
  }

  Optional<Mission> get(long task) {
    return Optional.ofNullable(open.get(task)).map(DatedMission::mission);
  }

  /** The mission that the robot works for. */
  Optional<Mission> missionOf(String robot) {
    if (byRobot == null) { // it is asked many times a tick for each robot
      byRobot = byRobot(open.values().stream().map(DatedMission::mission).toList());
    }
    return Optional.ofNullable(byRobot.get(robot));
  }

  /** The mission that the robot works for, as it is in the store; what starts goes by this one. */
  Optional<Mission> storedMissionOf(String robot) {
    if (storedByRobot == null) {
      storedByRobot = byRobot(stored.values());
    }
    return Optional.ofNullable(storedByRobot.get(robot));
  }

  /** The first mission that each robot works for. */
  private static Map<String, Mission> byRobot(Collection<Mission> missions) {
    Map<String, Mission> first = new HashMap<>();
    for (Mission mission : missions) {
      for (AssignedRobot assigned : mission.assignedRobots()) {
        if (!assigned.unassigned()) {
          first.putIfAbsent(assigned.robot(), mission);
        }
      }
    }
    return first;
  }

  Collection<DatedMission> all() {
    return open.values();
  }

  List<DatedMission> takeEnded() {
    List<DatedMission> taken = List.copyOf(ended);
    ended.clear();
    return taken;
  }
}
