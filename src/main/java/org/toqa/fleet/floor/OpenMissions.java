package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskView;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;
import org.toqa.wording.Sentence;

/**
 * A floor's missions that have not ended, those that ended since they were last told of, and what
 * of all that is stored. Confined to the floor's agent.
 */
final class OpenMissions {
  private final Map<Long, DatedMission> open = new LinkedHashMap<>();
  private final List<DatedMission> ended = new ArrayList<>();

  /** As they are in the store; those with robots only. */
  private final MissionIndex stored = new MissionIndex();

  private final MissionIndex openByRobot = new MissionIndex();

  /** A mission, and when it last changed. */
  static final class DatedMission {
    private final Mission mission;
    private final Instant changedAt;
    private @Nullable TaskView view;

    DatedMission(Mission mission, Instant changedAt) {
      this.mission = mission;
      this.changedAt = changedAt;
    }

    Mission mission() {
      return mission;
    }

    Instant changedAt() {
      return changedAt;
    }

    /**
     * As readers see it: the same from tick to tick while it waits for the same.
     *
     * @param waitingFor a sentence while it waits, else null
     */
    TaskView view(@Nullable Sentence waitingFor) {
      TaskView known = view;
      if (known == null || !Objects.equals(known.waitingFor(), waitingFor)) {
        known = TaskView.of(mission, waitingFor, changedAt);
        view = known;
      }
      return known;
    }
  }

  void put(Mission mission, Instant at) {
    if (mission.state().isEnded()) {
      remove(mission.id());
      ended.add(new DatedMission(mission, at));
    } else {
      open.put(mission.id(), new DatedMission(mission, at));
      openByRobot.put(mission);
    }
  }

  /** The mission is so in the store. */
  void setStored(Mission mission) {
    if (mission.state().isEnded() || mission.state() == TaskState.QUEUED) {
      stored.remove(mission.id());
    } else {
      stored.put(mission);
    }
  }

  void remove(long task) {
    open.remove(task);
    openByRobot.remove(task);
  }

  Optional<Mission> get(long task) {
    return Optional.ofNullable(open.get(task)).map(DatedMission::mission);
  }

  /** The mission that the robot works for. */
  Optional<Mission> missionOf(String robot) {
    return openByRobot.missionOf(robot);
  }

  /** The mission that the robot works for, as it is in the store; what starts goes by this one. */
  Optional<Mission> storedMissionOf(String robot) {
    return stored.missionOf(robot);
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
