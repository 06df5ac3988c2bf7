package org.toqa.fleet;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * How the smallest robot gets from here to there by the map alone; traffic may choose another way.
 *
 * @param points start, bends and goal, metres, map frame; empty where it can only go from cell to
 *     cell, as in an aisle hardly wider than the robot
 */
public record PathAnswer(String floor, List<Vec2> points) {
  public PathAnswer {
    points = List.copyOf(points);
  }

  /** How far that is, metres; 0 where there are no points. */
  public double metres() {
    return Vec2.lengthOf(points);
  }
}
