package org.toqa.geometry;

/**
 * A point where a path of straight legs bends or ends.
 *
 * @param position metres, map frame
 * @param turnOnSpot whether the robot stops here and turns into the next leg on the spot; otherwise
 *     it rounds the corner
 */
public record Waypoint(Vec2 position, boolean turnOnSpot) {}
