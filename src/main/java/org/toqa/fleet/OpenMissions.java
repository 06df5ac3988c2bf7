package org.toqa.fleet;

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
  private final Map<Long, Dated> open = new LinkedHashMap<>();
  private final List<Dated> ended = new ArrayList<>();

  /** A mission, and when it last changed. */
  record Dated(Mission mission, Instant changedAt) {}

  void put(Mission mission, Instant at) {
    if (mission.state().isEnded()) {
      open.remove(mission.id());
      ended.add(new Dated(mission, at));
    } else {
      open.put(mission.id(), new Dated(mission, at));
    }
  }

  void remove(long task) {
    open.remove(task);
  }

  Optional<Mission> get(long task) {
    return Optional.ofNullable(open.get(task)).map(Dated::mission);
  }

  /** The mission that the robot works for. */
  Optional<Mission> of(String robot) {
    return open.values().stream()
        .map(Dated::mission)
        .filter(m -> m.carrier(robot).filter(c -> !c.released()).isPresent())
        .findFirst();
  }

  Collection<Dated> all() {
    return open.values();
  }

  List<Dated> takeEnded() {
    List<Dated> taken = List.copyOf(ended);
    ended.clear();
    return taken;
  }
}
