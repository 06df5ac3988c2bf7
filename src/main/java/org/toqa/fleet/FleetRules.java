package org.toqa.fleet;

import java.time.Duration;

/**
 * What the fleet goes by.
 *
 * @param reassignAfter how long a robot is silent until its task goes to another
 * @param pace seconds of the fleet's time in a second of the clock by which people live; other than
 *     1 only where robots are simulated
 * @param checksPerUser how many orders and previews of one user are checked at once
 */
public record FleetRules(
    Duration reassignAfter, ChargingRules charging, double pace, int checksPerUser) {
  /** Usual for people, who order one after the other. */
  public static final int USUAL_CHECKS = 8;

  public FleetRules(Duration reassignAfter, ChargingRules charging, double pace) {
    this(reassignAfter, charging, pace, USUAL_CHECKS);
  }
}
