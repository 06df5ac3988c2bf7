package org.toqa.lab.cmct;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.lab.drawing.Colour;
import org.toqa.lab.drawing.Scene;

/** How a store is drawn. */
final class StoreMarks {
  private StoreMarks() {}

  /** Its occupied cells. */
  static List<Scene.Mark> walls(OccupancyGrid grid) {
    List<Scene.Mark> marks = new ArrayList<>();
    double half = grid.resolution() / 2;
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        if (!grid.isFree(column, row)) {
          Vec2 centre = grid.centre(new Cell(column, row));
          marks.add(
              new Scene.Area(
                  List.of(
                      centre.plus(new Vec2(-half, -half)),
                      centre.plus(new Vec2(half, -half)),
                      centre.plus(new Vec2(half, half)),
                      centre.plus(new Vec2(-half, half))),
                  Colour.WALL));
        }
      }
    }
    return marks;
  }
}
