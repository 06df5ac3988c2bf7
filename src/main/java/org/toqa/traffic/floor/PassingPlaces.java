package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
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

  /** Whether a place is between two cells: whoever stops there has still to go on to the next. */
  default boolean isHalfway(Vec2 point) {
    return false;
  }

  /**
   * In the middle of each cell, and perhaps on the border of two: so that whoever follows another
   * one comes as near as both may, and not only as near as whole cells allow.
   *
   * @param bordersToo only where robots in the middles of two cells keep their distance by
   *     themselves: on narrower cells one that is between two keeps others off more of them
   */
  record CellPlaces(OccupancyGrid cells, boolean bordersToo) implements PassingPlaces {
    /** How near to a cell's middle, or a border's, in cells, a robot counts as in it. */
    private static final double NEAR = 0.2;

    /** A straight that is so much along one axis goes over borders in their middles. */
    private static final double ALONG_AXIS = 0.999;

    @Override
    public List<Double> distancesAlong(Vec2 from, Vec2 forward, double length) {
      TreeSet<Double> found = new TreeSet<>();
      double step = cells.resolution() / 2;
      boolean isOverBorders =
          bordersToo && Math.max(Math.abs(forward.x()), Math.abs(forward.y())) > ALONG_AXIS;
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
        if (beside >= NEAR * cells.resolution()) {
          continue;
        }
        addInside(along, length, found);
        if (isOverBorders) {
          addInside(along - step, length, found);
          addInside(along + step, length, found);
        }
      }
      return List.copyOf(found);
    }

    /** Adds a place, unless it is hardly inside or was found from the cell before. */
    private void addInside(double along, double length, TreeSet<Double> found) {
      double least = NEAR * cells.resolution() / 2;
      Double before = found.floor(along + least);
      boolean isNew = before == null || before < along - least;
      if (isNew && along > least && along < length - least) {
        found.add(along);
      }
    }

    @Override
    public boolean isPassingPlace(Vec2 point, double covered) {
      return isCentre(point) || isHalfway(point);
    }

    /** Whether a robot there is in the middle of a cell. */
    boolean isCentre(Vec2 point) {
      return point.distanceTo(cells.centre(cells.cellAt(point))) < NEAR * cells.resolution();
    }

    @Override
    public boolean isHalfway(Vec2 point) {
      if (!bordersToo) {
        return false;
      }
      Vec2 aside = point.minus(cells.centre(cells.cellAt(point)));
      double more = Math.max(Math.abs(aside.x()), Math.abs(aside.y())) / cells.resolution();
      double less = Math.min(Math.abs(aside.x()), Math.abs(aside.y())) / cells.resolution();
      return less < NEAR && more > 0.5 - NEAR / 2;
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
