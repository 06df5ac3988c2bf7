package org.toqa.exploration;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * How far an exploration is.
 *
 * @param seconds of simulated time that it took
 * @param driven metres, of the virtual leader
 * @param remaining metres that it expects to drive yet, by what it knows
 * @param robots that still drive
 * @param track of the virtual leader, metres, map frame
 * @param seen of the ground by now
 */
public record ExplorationPicture(
    double seconds,
    double driven,
    double remaining,
    List<Robot> robots,
    List<Vec2> track,
    SeenGround seen) {

  /**
   * @param position metres, map frame
   * @param sees whether its lidar is on
   */
  public record Robot(Vec2 position, boolean sees) {}

  public ExplorationPicture {
    robots = List.copyOf(robots);
    track = List.copyOf(track);
  }

  /** How much of the way is done, by what is known now: 0 to 1. */
  public double share() {
    double whole = driven + remaining;
    return whole > 0 ? driven / whole : 1;
  }
}
