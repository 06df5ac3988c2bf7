package org.toqa.fleet.floor;

import java.util.Optional;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.TaskPlace;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Whether a robot can come to a place of a floor at all, by its map. */
public final class PlaceCheck {
  /** Half the diameter of the smallest robot there is, metres: where it cannot be, none can. */
  public static final double SMALLEST_RADIUS = 0.1275;

  private PlaceCheck() {}

  /**
   * @param what is there, such as {@link Phrase#START}
   * @return what speaks against it
   */
  public static Optional<Sentence> objection(OccupancyGrid grid, Phrase what, TaskPlace place) {
    if (!grid.contains(grid.cellAt(place.position()))) {
      Vec2 low = grid.origin();
      Vec2 high = low.plus(new Vec2(grid.width(), grid.height()).times(grid.resolution()));
      return Optional.of(
          Phrase.LIES_OFF_MAP.with(
              what.with(), place.sentence(), Sentence.of(low), Sentence.of(high)));
    }
    return canStand(grid, place.position())
        ? Optional.empty()
        : Optional.of(Phrase.LIES_IN_WALL.with(what.with(), place.sentence()));
  }

  /** Whether the smallest robot can be on the point itself, or in the middle of its cell. */
  private static boolean canStand(OccupancyGrid grid, Vec2 point) {
    Cell cell = grid.cellAt(point);
    Disc robot = new Disc(SMALLEST_RADIUS);
    return robot.isFreeAt(grid, point) || robot.isFreeAt(grid, grid.centre(cell));
  }
}
