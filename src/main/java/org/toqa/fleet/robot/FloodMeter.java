package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import org.toqa.fleet.RobotMessageKind;

/**
 * Counts what is left out of what one robot says, and finds out when people should know: once when
 * it becomes too much, and once when it is over. It knows no clock: time is handed in.
 */
public final class FloodMeter {
  private static final Duration WINDOW = Duration.ofSeconds(10);
  private static final Duration RECOVERY = Duration.ofSeconds(60);

  private final AgentHealth health;
  private final Map<RobotMessageKind, Long> counts = new EnumMap<>(RobotMessageKind.class);
  private final Set<RobotMessageKind> told = EnumSet.noneOf(RobotMessageKind.class);
  private Instant windowBegin = Instant.EPOCH;
  private Instant lastFlood = Instant.EPOCH;

  /**
   * @param health is told of all that is left out
   */
  public FloodMeter(AgentHealth health) {
    this.health = health;
  }

  /**
   * Some were left out.
   *
   * @return whether it has just become too much
   */
  public boolean record(RobotMessageKind kind, long count, Instant now) {
    health.recordPassedOver(kind, count);
    if (Duration.between(windowBegin, now).compareTo(WINDOW) > 0) {
      windowBegin = now;
      counts.clear();
    }
    if (counts.merge(kind, count, Long::sum) <= kind.tolerance()) {
      return false;
    }
    lastFlood = now;
    return told.add(kind);
  }

  /** Whether what was too much has just been over for long enough. To be called at each tick. */
  public boolean detectRecovery(Instant now) {
    if (told.isEmpty() || Duration.between(lastFlood, now).compareTo(RECOVERY) < 0) {
      return false;
    }
    told.clear();
    return true;
  }
}
