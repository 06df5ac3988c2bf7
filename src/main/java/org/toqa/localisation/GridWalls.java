package org.toqa.localisation;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

/** The faces of the occupied cells of a grid; what lies outside the grid is a wall. */
public record GridWalls(OccupancyGrid grid) implements Walls {

  @Override
  public Optional<Hit> hit(Pose beam, double farthest) {
    Search search = new Search();
    RayCast.walk(
        grid.resolution(),
        beam.position().minus(grid.origin()),
        beam.theta(),
        farthest,
        search::visit);
    return Optional.ofNullable(search.hit);
  }

  /** Goes through free cells until it leaves one for another that is not. */
  private final class Search {
    private boolean isInFree;
    private int lastColumn;
    private int lastUp;
    private @Nullable Hit hit;

    boolean visit(int column, int up, double entered, double left) {
      if (grid.isFree(column, grid.height() - 1 - up)) {
        isInFree = true;
        lastColumn = column;
        lastUp = up;
        return true;
      }
      if (isInFree) {
        hit = new Hit(entered, new Vec2(lastColumn - column, lastUp - up));
      }
      return false;
    }
  }
}
