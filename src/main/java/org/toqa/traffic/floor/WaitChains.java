package org.toqa.traffic.floor;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Whom robots wait for in the end, where those that they wait for wait for others themselves. */
final class WaitChains {
  /**
   * By robot: the last of its chain of waits, where that does not go on by itself just now; itself
   * where it waits for none.
   */
  private final Map<String, Optional<String>> ends = new HashMap<>();

  /**
   * Looks at each robot once.
   *
   * @param robots all, by name
   */
  void update(Map<String, TrafficRobot> robots) {
    ends.clear();
    for (TrafficRobot first : robots.values()) {
      LinkedHashSet<TrafficRobot> chain = new LinkedHashSet<>();
      TrafficRobot at = first;
      while (at != null && !ends.containsKey(at.name) && chain.add(at)) {
        at = next(at, robots);
      }
      Optional<String> end =
          at == null
              ? Optional.of(chain.getLast()).filter(WaitChains::stays).map(robot -> robot.name)
              : ends.getOrDefault(at.name, Optional.empty()); // none of a ring
      chain.forEach(robot -> ends.put(robot.name, end));
    }
  }

  /** See {@link FloorTraffic#blockingRobot}. */
  Optional<String> blockingRobot(TrafficRobot robot) {
    return ends.getOrDefault(robot.name, Optional.empty()).filter(end -> !end.equals(robot.name));
  }

  /** Why it does not go on; null while it does. */
  @Nullable Sentence sentence(TrafficRobot robot) {
    WaitReason reason = robot.waitReason();
    if (reason == null) {
      return null;
    }
    return blockingRobot(robot)
        .filter(blocking -> !blocking.equals(reason.robot()))
        .map(blocking -> Phrase.WAITS_BEHIND.with(reason.sentence(), blocking))
        .orElseGet(reason::sentence);
  }

  private static boolean stays(TrafficRobot robot) {
    return isHindered(robot) || !robot.drive.isDriving();
  }

  private static boolean isHindered(TrafficRobot robot) {
    return !robot.isMovable() || robot.isStalled();
  }

  private static @Nullable TrafficRobot next(TrafficRobot robot, Map<String, TrafficRobot> robots) {
    WaitReason reason = isHindered(robot) ? null : robot.waitReason();
    String other = reason == null ? null : reason.robot();
    return other == null ? null : robots.get(other);
  }
}
