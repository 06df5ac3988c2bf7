package org.toqa.telemetry;

import java.util.List;
import java.util.Optional;

/**
 * By which passwords robots publish, and the limits of their readings. Both end with the robot.
 *
 * <p>Any thread may call it and may have to wait. Every method throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer.
 */
public interface TelemetryStore {

  /** SHA-256, hex; empty: the robot has no password. */
  Optional<String> passwordHash(String robot);

  /**
   * Instead of the one before, which is told in the history.
   *
   * @param by who made it
   */
  void setPasswordHash(String robot, String hash, String by);

  /** All of the site. */
  List<ReadingLimits> limits();

  /** Instead of those before; {@link ReadingLimits#isNone}: there are none any more. */
  void setLimits(ReadingLimits limits);
}
