package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;

/** Measures what one robot does, by looking at it again and again. */
final class UseMeter {
  /** With such pieces the days of nearly every time zone can be put together. */
  private static final Duration PIECE = Duration.ofMinutes(30);

  /** What was between two looks farther apart is not known: the server did not run. */
  private static final Duration LONGEST_GAP = Duration.ofSeconds(10);

  private final String robot;
  private final double pace;
  private final DrivenWay way = new DrivenWay();
  private final BatteryDrain drain = new BatteryDrain();
  private final Map<RobotUse, Duration> time = new EnumMap<>(RobotUse.class);

  private Instant begun;
  private Instant lookedAt;
  private RobotUse use;
  private double metres;
  private double battery;

  /**
   * @param pace as {@link FleetRules} has it
   */
  UseMeter(RobotView first, Instant now, double pace) {
    this.pace = pace;
    robot = first.name();
    begun = now;
    lookedAt = now;
    use = RobotUse.of(first);
    measure(first);
  }

  /** The record of the half hour that is over, where this look is the first of another. */
  Optional<UseRecord> look(RobotView view, Instant now) {
    Duration gap = Duration.between(lookedAt, now);
    if (gap.isPositive() && gap.compareTo(LONGEST_GAP) <= 0) {
      time.merge(use, gap, Duration::plus);
    }
    lookedAt = now;
    use = RobotUse.of(view);
    measure(view);
    if (piece(now) == piece(begun)) {
      return Optional.empty();
    }
    UseRecord over = record();
    begin(now);
    return Optional.of(over);
  }

  /** As far as it is known now. */
  UseRecord record() {
    return new UseRecord(robot, begun, time, metres, battery);
  }

  private void begin(Instant now) {
    begun = now;
    time.clear();
    metres = 0;
    battery = 0;
  }

  private void measure(RobotView view) {
    if (view.pose() != null && view.lastSeen() != null) {
      metres += way.add(view.lastSeen(), view.pose().position(), pace * view.speed());
    }
    if (view.battery() != null) {
      battery += drain.add(view.battery());
    }
  }

  private static long piece(Instant moment) {
    return Math.floorDiv(moment.toEpochMilli(), PIECE.toMillis());
  }
}
