package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** Where a robot may stop on its path, so that a section may end there. */
sealed interface PassingPlaces {

  /**
   * How far along a straight there are such places, metres, rising; its ends left out.
   *
   * @param forward of length 1
   */
  List<Double> distancesAlong(Vec2 from, Vec2 forward, double length);

  /**
   * Whether a section may end at a point.
   *
   * @param covered metres from where it began
   */
  boolean isPassingPlace(Vec2 point, double covered);

  /** In the middle of each cell. */
  record CellCentres(OccupancyGrid cells) implements PassingPlaces {
    /** How near to a cell's middle, in cells, a robot counts as in it. */
    private static final double NEAR = 0.2;

    @Override
    public List<Double> distancesAlong(Vec2 from, Vec2 forward, double length) {
      List<Double> found = new ArrayList<>();
      double step = cells.resolution() / 2;
      Cell last = null;
      for (double s = 0; s <= length; s += step) {
        Cell cell = cells.cellAt(from.plus(forward.times(s)));
        if (cell.equals(last)) {
          continue;
        }
        last = cell;
        Vec2 toMiddle = cells.centre(cell).minus(from);
        double along = toMiddle.x() * forward.x() + toMiddle.y() * forward.y();
        double beside = Math.abs(toMiddle.y() * forward.x() - toMiddle.x() * forward.y());
        boolean isInside = along > NEAR * step && along < length - NEAR * step;
        if (beside < NEAR * cells.resolution() && isInside) {
          found.add(along);
        }
      }
      return found;
    }

    @Override
    public boolean isPassingPlace(Vec2 point, double covered) {
      return point.distanceTo(cells.centre(cells.cellAt(point))) < NEAR * cells.resolution();
    }
  }

  /** Anywhere, but not more often than each so many metres. */
  record Spaced(double spacing) implements PassingPlaces {
    private static final double ROUNDING = 1e-9;

    @Override
    public List<Double> distancesAlong(Vec2 from, Vec2 forward, double length) {
      List<Double> found = new ArrayList<>();
      int pieces = (int) (length / spacing + ROUNDING);
      for (int i = 1; i < pieces; i++) {
        found.add(i * length / pieces);
      }
      return found;
    }

    @Override
    public boolean isPassingPlace(Vec2 point, double covered) {
      return covered > spacing - ROUNDING;
    }
  }

  /** Not before the end of the path. */
  record OnlyAtEnd() implements PassingPlaces {
    @Override
    public List<Double> distancesAlong(Vec2 from, Vec2 forward, double length) {
      return List.of();
    }

    @Override
    public boolean isPassingPlace(Vec2 point, double covered) {
      return false;
    }
  }
}
