package org.toqa.formation.swarm;

import org.toqa.geometry.Vec2;

/**
 * A robot of a swarm that still drives.
 *
 * @param position metres, map frame
 * @param wanted metres from the virtual leader, map frame: the shape does not turn
 */
public record SwarmRobot(Vec2 position, Vec2 wanted) {}
