package org.toqa.exploration;

import java.util.random.RandomGenerator;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

/**
 * A simulated lidar that looks all round: 360 rays of 8 m, ranges with a standard deviation of 10
 * mm. Other robots are not in its way.
 */
final class RobotLidar {
  static final double RANGE = 8;
  private static final int RAYS = 360;
  private static final double NOISE = 0.01;

  private RobotLidar() {}

  /**
   * What one turn of it read.
   *
   * @param from metres, map frame
   * @param ranges metres, the first to map east, counter-clockwise; {@link #RANGE} where nothing is
   */
  record Scan(Vec2 from, double[] ranges) {
    private static double direction(int ray) {
      return 2 * Math.PI * ray / RAYS;
    }

    /** The shortest range to either side of a direction, by so many radians. */
    double nearest(double direction, double view) {
      double nearest = RANGE;
      for (int i = 0; i < RAYS; i++) {
        if (Math.abs(Angles.difference(direction, direction(i))) <= view) {
          nearest = Math.min(nearest, ranges[i]);
        }
      }
      return nearest;
    }

    void addTo(EvidenceGrid map) {
      for (int i = 0; i < RAYS; i++) {
        map.addRay(from, direction(i), ranges[i], ranges[i] < RANGE);
      }
    }
  }

  static Scan scan(OccupancyGrid truth, Vec2 from, RandomGenerator random) {
    double[] ranges = new double[RAYS];
    for (int i = 0; i < RAYS; i++) {
      double range = RayCast.distance(truth, from, Scan.direction(i), RANGE);
      double read = Math.max(0, range + NOISE * random.nextGaussian());
      ranges[i] = range < RANGE ? Math.min(RANGE, read) : RANGE;
    }
    return new Scan(from, ranges);
  }
}
