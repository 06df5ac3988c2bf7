package org.toqa.exploration;

import org.toqa.geometry.Vec2;

/**
 * Who is to explore, and whereto.
 *
 * @param robots 1 to {@link #MOST_ROBOTS}
 * @param start of the middle of all, metres, map frame
 * @param target metres, map frame
 * @param seed of chance: the same one gives the same drive
 */
public record ExplorationOrder(int robots, Vec2 start, Vec2 target, long seed) {
  public static final int MOST_ROBOTS = 9;
}
