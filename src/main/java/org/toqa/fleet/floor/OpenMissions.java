package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.mission.Mission;

/**
 * A floor's missions that have not ended, and those that ended since they were last told of.
 * Confined to the floor's agent.
 */
final class OpenMissions {
  private final Map<Long, DatedMission> open = new LinkedHashMap<>();
  private final List<DatedMission> ended = new ArrayList<>();

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
        .filter(m -> m.assignedRobot(robot).filter(c -> !c.unassigned()).isPresent())
        .findFirst();
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
