package org.toqa.avoidance.fouragents;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * The perception agent: gathers the sensors' readings, and tells apart what is known from what is
 * not. A reading is known if it is no shorter than what the outlines of known obstacles let the
 * sensor expect: so what stands before a known thing is seen. Of an obstacle of which only the
 * circle is known, all readings in that circle are.
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
      all.add(range);
      unknown.add(isKnown(robot.compose(beams.get(i)), range, known) ? ring.farthest() : range);
    }
    return new Percept(List.copyOf(all), List.copyOf(unknown));
  }

  private boolean isKnown(Pose beam, double range, List<StaticObstacle> known) {
    Vec2 point = beam.compose(new Pose(range, 0, 0)).position();
    double expected = ring.farthest();
    for (StaticObstacle obstacle : known) {
      if (obstacle.outline().isEmpty() && obstacle.contains(point, tolerance)) {
        return true;
      }
      for (Pose ray : RangeRing.rays(beam)) {
        expected = obstacle.range(ray, expected);
      }
    }
    return expected < ring.farthest() && range >= expected - tolerance;
  }
}
