package org.toqa.avoidance.fouragents;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * The perception agent: gathers the sensors' readings, and tells apart what is known from what is
 * not. A reading belongs to a known obstacle if its point is within the obstacle's circle, or
 * beside it by less than the tolerance.
 *
 * @param ring the sensors
 * @param tolerance metres: noise of sensors and pose
 */
record Perception(RangeRing ring, double tolerance) {

  /**
   * @param ranges metres, one a sensor; NaN, negative or missing ones read as 0: what a broken
   *     sensor does not see may be there
   * @param robot where it is, map frame
   */
  Percept percept(List<Double> ranges, Pose robot, List<StaticObstacle> known) {
    List<Double> all = new ArrayList<>();
    List<Double> unknown = new ArrayList<>();
    List<Pose> beams = ring.beams();
    for (int i = 0; i < RangeRing.SIZE; i++) {
      double reading = i < ranges.size() ? ranges.get(i) : 0;
      double range = reading >= 0 ? Math.min(reading, ring.farthest()) : 0;
      Vec2 point = robot.compose(beams.get(i)).compose(new Pose(range, 0, 0)).position();
      boolean isKnown =
          known.stream().anyMatch(o -> o.centre().distanceTo(point) <= o.radius() + tolerance);
      all.add(range);
      unknown.add(isKnown ? ring.farthest() : range);
    }
    return new Percept(List.copyOf(all), List.copyOf(unknown));
  }
}
