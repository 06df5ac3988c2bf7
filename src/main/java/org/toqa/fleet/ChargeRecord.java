package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * What is stored of a robot's charging.
 *
 * @param worked how long it has worked since it last charged
 * @param turn null: it need not charge
 */
public record ChargeRecord(String robot, Duration worked, @Nullable Turn turn) {

  /**
   * A robot's place at a charging point: there, driving to it, or behind others.
   *
   * @param point the charging point's name
   * @param since who came earlier comes first
   */
  public record Turn(String point, Instant since) {}
}
