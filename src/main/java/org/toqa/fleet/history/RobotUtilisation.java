package org.toqa.fleet.history;

import java.time.Duration;
import java.util.Map;
import java.util.stream.Stream;

/**
 * What one robot did in a period.
 *
 * @param time how long it did what, as far as the server ran; every use is there
 * @param metres that it drove
 * @param battery the sum of all falls of its charge, as a share of a full battery; at least 0
 */
public record RobotUtilisation(
    String robot, Map<RobotActivity, Duration> time, double metres, double battery) {

  /** How long it did that, in seconds, to the millisecond. */
  public double seconds(RobotActivity use) {
    return time.getOrDefault(use, Duration.ZERO).toMillis() / 1000.0;
  }

  /** How long the server looked at it, in seconds. */
  public double recordedSeconds() {
    return Stream.of(RobotActivity.values()).mapToDouble(this::seconds).sum();
  }

  /** The part of that time; 0 to 1. */
  public double utilisation(RobotActivity use) {
    double all = recordedSeconds();
    return all == 0 ? 0 : seconds(use) / all;
  }
}
