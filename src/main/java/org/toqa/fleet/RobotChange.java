package org.toqa.fleet;

import org.jspecify.annotations.Nullable;

/**
 * An order for another address, strength or parking point of a robot.
 *
 * @param maxLoad kilograms
 * @param parking a parking point's name; null: it stays where its last task ends
 * @param gateway that reaches it; null: the server does
 */
public record RobotChange(
    String host, int port, double maxLoad, @Nullable String parking, @Nullable String gateway) {

  /** Of a robot that the server reaches itself. */
  public RobotChange(String host, int port, double maxLoad, @Nullable String parking) {
    this(host, port, maxLoad, parking, null);
  }
}
