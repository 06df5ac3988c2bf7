package org.toqa.store;

import java.time.Duration;
import java.util.Map;
import java.util.stream.Stream;
import org.toqa.fleet.RobotUse;

/**
 * What one robot did in a period.
 *
 * @param time how long it did what, as far as the server ran; every use is there
 * @param metres that it drove
 * @param battery how much its battery fell; 1 is a full one
 */
public record RobotFigures(
    String robot, Map<RobotUse, Duration> time, double metres, double battery) {

  public double seconds(RobotUse use) {
    return time.getOrDefault(use, Duration.ZERO).toMillis() / 1000.0;
  }

  /** How long the server looked at it, in seconds. */
  public double recorded() {
    return Stream.of(RobotUse.values()).mapToDouble(this::seconds).sum();
  }

  /** The part of that time; 0 to 1. */
  public double share(RobotUse use) {
    double all = recorded();
    return all == 0 ? 0 : seconds(use) / all;
  }
}
