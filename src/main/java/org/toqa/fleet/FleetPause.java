package org.toqa.fleet;

import java.time.Instant;

/**
 * All robots are on hold. This is no safety function: a robot that hears nothing drives what was
 * released to it to its end.
 *
 * @param user who paused them
 */
public record FleetPause(String user, Instant since) {}
