package org.toqa.telemetry;

import java.time.Instant;
import java.util.List;

/**
 * What a robot measured last of one kind.
 *
 * @param stamp the robot's clock, milliseconds since 1970; information only
 * @param receivedAt when the server heard it
 * @param values of {@link #RANGE} one for each sensor, from right to left; else exactly one
 * @param unit of the values; empty: the robot does not say it
 * @param angles of {@link #RANGE}, where each sensor looks: radians, counter-clockwise from
 *     straight ahead; empty: the robot does not say it
 */
public record Reading(
    String name,
    long stamp,
    Instant receivedAt,
    List<Double> values,
    String unit,
    List<Double> angles) {
  /** The name of what range sensors measure, metres. */
  public static final String RANGE = "range";

  public Reading {
    values = List.copyOf(values);
    angles = List.copyOf(angles);
  }

  public double least() {
    return values.stream().mapToDouble(Double::doubleValue).min().orElseThrow();
  }

  public double greatest() {
    return values.stream().mapToDouble(Double::doubleValue).max().orElseThrow();
  }
}
