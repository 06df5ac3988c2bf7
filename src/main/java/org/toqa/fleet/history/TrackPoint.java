package org.toqa.fleet.history;

import java.time.Instant;
import org.toqa.geometry.Vec2;

/**
 * A robot was there. Between two points it went straight, to within a few centimetres.
 *
 * @param position metres, map frame
 */
public record TrackPoint(String robot, Instant at, Vec2 position) {}
