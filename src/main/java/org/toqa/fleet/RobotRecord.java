package org.toqa.fleet;

import org.jspecify.annotations.Nullable;

/**
 * A robot as it is stored.
 *
 * @param maxLoad kilograms
 * @param parking a parking point's name; null: it stays where its last task ends
 * @param simulated whether its daemon runs in the server's process
 */
public record RobotRecord(
    String name,
    String floor,
    String host,
    int port,
    double maxLoad,
    @Nullable String parking,
    boolean simulated) {}
