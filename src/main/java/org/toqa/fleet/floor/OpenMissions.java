package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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

  /** A mission, and when it last changed. */
  record DatedMission(Mission mission, Instant changedAt) {}

  void put(Mission mission, Instant at) {
    if (mission.state().isEnded()) {
      open.remove(mission.id());
      ended.add(new DatedMission(mission, at));
    } else {
      open.put(mission.id(), new DatedMission(mission, at));
    }
  }

  /** The mission is so in the store. */
  void setStored(Mission mission) {
    if (mission.state().isEnded() || mission.state() == TaskState.QUEUED) {
      stored.remove(mission.id());
    } else {
      stored.put(mission.id(), mission);
    }
  }

  void remove(long task) {
    open.remove(task);
  }

  Optional<Mission> get(long task) {
    return Optional.ofNullable(open.get(task)).map(DatedMission::mission);
  }

  /** The mission that the robot works for. */
  Optional<Mission> missionOf(String robot) {
    return open.values().stream()
        .map(DatedMission::mission)
        .filter(m -> isWorking(robot, m))
        .findFirst();
  }

  /** The mission that the robot works for, as it is in the store; what starts goes by this one. */
  Optional<Mission> storedMissionOf(String robot) {
    return stored.values().stream().filter(m -> isWorking(robot, m)).findFirst();
  }

  private static boolean isWorking(String robot, Mission mission) {
    return mission.assignedRobot(robot).filter(c -> !c.unassigned()).isPresent();
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
