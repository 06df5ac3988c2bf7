package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Vec2;

/** Points on a floor, found by place: a question costs as much as there is near to it. */
final class PointIndex {
  private final double reach;
  private final Map<Square, List<Vec2>> bySquare = new HashMap<>();

  /**
   * @param reach points nearer than that to each other are near, metres, above 0
   */
  PointIndex(double reach) {
    this.reach = reach;
  }

  /** Metres, map frame. */
  void add(Vec2 point) {
    bySquare.computeIfAbsent(square(point), s -> new ArrayList<>()).add(point);
  }

  /** Whether one of the points is near to another. */
  boolean hasNear(Vec2 other) {
    Square middle = square(other);
    for (int column = middle.column() - 1; column <= middle.column() + 1; column++) {
      for (int row = middle.row() - 1; row <= middle.row() + 1; row++) {
        if (bySquare.getOrDefault(new Square(column, row), List.of()).stream()
            .anyMatch(point -> point.distanceTo(other) < reach)) {
          return true;
        }
      }
    }
    return false;
  }

  private Square square(Vec2 point) {
    return new Square((int) Math.floor(point.x() / reach), (int) Math.floor(point.y() / reach));
  }
}
