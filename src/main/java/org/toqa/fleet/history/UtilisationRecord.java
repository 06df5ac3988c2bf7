package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;

/**
 * What a robot did from some moment on, within half an hour.
 *
 * @param time how long it did what; what is not in it took no time
 * @param metres that it drove
 * @param battery the sum of all falls of its charge, as a share of a full battery; at least 0
 */
public record UtilisationRecord(
    String robot, Instant at, Map<RobotActivity, Duration> time, double metres, double battery) {
  public UtilisationRecord {
    time = Map.copyOf(time);
  }
}
