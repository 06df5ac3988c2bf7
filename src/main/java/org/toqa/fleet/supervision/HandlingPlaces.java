package org.toqa.fleet.supervision;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmStance;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/** Where a robot can stand so that its arm comes to a place: in the middles of cells. */
final class HandlingPlaces {
  /** Share of what the arm reaches: there it comes to a place also where the robot errs. */
  private static final double BEST_REACH = 0.75;

  /** Metres that a robot may stand elsewhere than it was told, or a box lie. */
  private static final double ERROR = 0.04;

  private HandlingPlaces() {}

  /**
   * Points on which a robot can stand; whether a path leads there, only the fleet knows.
   *
   * @param target metres, map frame
   * @param drivable where its middle can be
   * @return the better ones first
   */
  static List<Vec2> round(Vec2 target, Arm arm, OccupancyGrid drivable) {
    double farthest = arm.base().position().norm() + arm.farthest();
    double best = BEST_REACH * farthest;
    int cells = (int) Math.ceil(farthest / drivable.resolution());
    return drivable.cellsAround(target, cells).stream()
        .filter(drivable::isFree)
        .map(drivable::centre)
        .filter(stand -> isInReach(arm, stand, target))
        .sorted(Comparator.comparingDouble(stand -> Math.abs(stand.distanceTo(target) - best)))
        .toList();
  }

  private static boolean isInReach(Arm arm, Vec2 stand, Vec2 target) {
    Vec2 way = target.minus(stand);
    double metres = way.norm();
    return metres > 2 * ERROR
        && Stream.of(metres - ERROR, metres, metres + ERROR)
            .map(distance -> stand.plus(way.times(distance / metres)))
            .allMatch(point -> ArmStance.find(arm, stand, point) instanceof ArmStance.Facing);
  }
}
