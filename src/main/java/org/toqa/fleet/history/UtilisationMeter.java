package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Telemetry;

/** Measures what one robot does, by looking at it again and again. */
final class UtilisationMeter {
  /** With such pieces the days of nearly every time zone can be put together. */
  private static final Duration PIECE = Duration.ofMinutes(30);

  /** What was between two looks farther apart is not known: the server did not run. */
  private static final Duration LONGEST_GAP = Duration.ofSeconds(10);

  private final String robot;
  private final double pace;
  private final Odometer odometer = new Odometer();
  private final BatteryDrain drain = new BatteryDrain();
  private final Map<RobotActivity, Duration> time = new EnumMap<>(RobotActivity.class);

  private Instant begun;
  private Instant observedAt;
  private RobotActivity activity;
  private double metres;
  private double battery;

  /**
   * @param pace as {@link org.toqa.fleet.FleetRules} has it
   */
  UtilisationMeter(RobotView first, Instant now, double pace) {
    this.pace = pace;
    robot = first.name();
    begun = now;
    observedAt = now;
    activity = RobotActivity.of(first);
    measure(first);
  }

  /** The record of the half hour that is over, where this look is the first of another. */
  Optional<UtilisationRecord> observe(RobotView view, Instant now) {
    Duration gap = Duration.between(observedAt, now);
    if (gap.isPositive() && gap.compareTo(LONGEST_GAP) <= 0) {
      time.merge(activity, gap, Duration::plus);
    }
    observedAt = now;
    activity = RobotActivity.of(view);
    measure(view);
    if (piece(now) == piece(begun)) {
      return Optional.empty();
    }
    UtilisationRecord over = record();
    beginRecord(now);
    return Optional.of(over);
  }

  /** As far as it is known now. */
  UtilisationRecord record() {
    return new UtilisationRecord(robot, begun, time, metres, battery);
  }

  private void beginRecord(Instant now) {
    begun = now;
    time.clear();
    metres = 0;
    battery = 0;
  }

  private void measure(RobotView view) {
    Telemetry seen = view.telemetry();
    if (seen.pose() != null && seen.lastSeen() != null) {
      double speed = pace * view.speed();
      metres += odometer.add(seen.lastSeen(), seen.pose().position(), speed);
    }
    if (seen.battery() != null) {
      battery += drain.add(seen.battery());
    }
  }

  private static long piece(Instant moment) {
    return Math.floorDiv(moment.toEpochMilli(), PIECE.toMillis());
  }
}
