package org.toqa.fleet.history;

import java.time.Instant;
import java.util.List;
import java.util.Map;

/**
 * Where several robots were in a period.
 *
 * @param until the first moment after it; earlier than asked for where there was more than wanted
 * @param points of each robot, oldest first: those of the period, up to two from before it, which
 *     say where the robot was when it began and from where it had come, and the one that follows it
 */
public record FloorTracks(Instant until, Map<String, List<TrackPoint>> points) {}
