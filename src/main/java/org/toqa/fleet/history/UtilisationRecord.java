package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;

/**
 * What a robot did from some moment on, within half an hour.
 *
 * @param time how long it did what; what is not in it took no time
 * @param metres that it drove
 * @param battery how much its battery fell; 1 is a full one
 */
public record UtilisationRecord(
    String robot, Instant at, Map<RobotActivity, Duration> time, double metres, double battery) {
  public UtilisationRecord {
    time = Map.copyOf(time);
  }
}
