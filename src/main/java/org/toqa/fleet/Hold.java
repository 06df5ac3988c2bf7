package org.toqa.fleet;

import java.time.Instant;

/**
 * All robots, or those of a floor, are on hold. This is no safety function: a robot that hears
 * nothing drives what was released to it to its end.
 *
 * @param user who put them on hold
 */
public record Hold(String user, Instant since) {}
