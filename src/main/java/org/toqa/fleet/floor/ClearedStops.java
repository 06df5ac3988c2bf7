package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import org.toqa.link.message.AgentMessage.Fault;

/** What a person cleared last, until the robot has shown what came of it. */
final class ClearedStops {
  /** By then the robot has answered or was given up, and its body has obeyed. */
  private static final Duration EFFECT_AFTER = Duration.ofSeconds(6);

  private Set<String> reasons = Set.of();
  private Instant due = Instant.MAX;

  void begin(Set<String> cleared, Instant now) {
    reasons = cleared;
    due = now.plus(EFFECT_AFTER);
  }

  /** People know already what came of it. */
  void settle() {
    reasons = Set.of();
  }

  /**
   * Which of the stops last though they were cleared; told once, when it is time.
   *
   * @param faults that the robot reports now
   * @return their codes, in order
   */
  List<String> takeLasting(List<Fault> faults, Instant now) {
    if (reasons.isEmpty() || now.isBefore(due)) {
      return List.of();
    }
    Set<String> cleared = reasons;
    settle();
    return faults.stream()
        .filter(Fault::clearable)
        .map(Fault::code)
        .filter(cleared::contains)
        .distinct()
        .sorted()
        .toList();
  }
}
