package org.toqa.fleet.dispatch;

import java.util.List;
import org.toqa.geometry.Vec2;

/** Whether and where a robot alone can drive between two points of an empty floor. */
sealed interface FloorPath {

  /**
   * @param points start, bends and goal, metres, map frame
   */
  record Found(List<Vec2> points) implements FloorPath {
    public Found {
      points = List.copyOf(points);
    }
  }

  /** Only between the middles of cells, as in an aisle hardly wider than the robot. */
  record FoundBetweenCells() implements FloorPath {}

  record NotFound() implements FloorPath {}
}
