package org.toqa.fleet;

import org.jspecify.annotations.Nullable;

/**
 * A wish for a new robot.
 *
 * @param maxLoad kilograms
 * @param parking a parking point's name; null: the first that no robot has
 */
public record RobotOrder(
    String name, String host, int port, double maxLoad, @Nullable String parking) {}
