package org.toqa.traffic.floor;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Objects;
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

  /** By robot, what was said last; kept, since most is the same from tick to tick. */
  private final Map<String, Told> told = new HashMap<>();

  private record Told(WaitReason reason, @Nullable String blocking, Sentence sentence) {
    @SuppressWarnings("ReferenceEquality") // a robot keeps its reason while that stays the same
    boolean isOf(WaitReason otherReason, @Nullable String otherBlocking) {
      return reason == otherReason && Objects.equals(blocking, otherBlocking);
    }
  }

  /**
   * Looks at each robot that waits once, and at each that others wait for.
   *
   * @param robots all, by name
   */
  void update(Map<String, TrafficRobot> robots) {
    ends.clear();
    if (told.size() > robots.size()) {
      told.keySet().retainAll(robots.keySet());
    }
    for (TrafficRobot first : robots.values()) {
      if (next(first, robots) == null) {
        continue; // it is the end of its own chain, and of those that come to it
      }
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
    String blocking =
        blockingRobot(robot).filter(other -> !other.equals(reason.robot())).orElse(null);
    Told known = told.get(robot.name);
    if (known == null || !known.isOf(reason, blocking)) {
      Sentence sentence = reason.sentence();
      known =
          new Told(
              reason,
              blocking,
              blocking == null ? sentence : Phrase.WAITS_BEHIND.with(sentence, blocking));
      told.put(robot.name, known);
    }
    return known.sentence();
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
