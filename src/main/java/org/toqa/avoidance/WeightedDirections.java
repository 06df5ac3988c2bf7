package org.toqa.avoidance;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * Which direction to take between a goal that pulls and things that push: every thing seen pushes
 * away from its own direction, the harder the nearer it is, and the sum of all shows the direction.
 *
 * <p>Of the family of potential fields, and as blind as these to dead ends: it is for the last
 * centimetres of a path that was planned (Tanta, "Obstacle avoidance on the robot").
 */
public final class WeightedDirections {

  /** Metres from the robot's middle; what is farther does not push. */
  public static final double REACH = 1;

  private WeightedDirections() {}

  /**
   * @param next displacement from the robot to where it wants to go, in any frame
   * @param seen displacements from the robot to the things seen, in the same frame
   * @return a vector of length 1 at most, in the same frame; zero where nothing prevails
   */
  public static Vec2 direction(Vec2 next, List<Vec2> seen) {
    return direction(next, seen, 0, REACH);
  }

  /**
   * The same where things push within a reach of their own.
   *
   * @param nearest metres from the robot's middle; what is so near pushes with all its weight
   * @param reach metres from the robot's middle, more than that; what is farther does not push
   */
  public static Vec2 direction(Vec2 next, List<Vec2> seen, double nearest, double reach) {
    // D = (d_np + sum w_i d_i) / number of directions
    Vec2 sum = unit(next);
    for (Vec2 thing : seen) {
      sum = sum.plus(unit(thing).times(-weight(thing.norm(), nearest, reach)));
    }
    return sum.times(1.0 / (1 + seen.size()));
  }

  /** How hard a thing pushes, 1 where it touches to 0 out of reach. */
  static double weight(double metres) {
    return weight(metres, 0, REACH);
  }

  private static double weight(double metres, double nearest, double reach) {
    return Math.clamp((reach - metres) / (reach - nearest), 0, 1);
  }

  private static Vec2 unit(Vec2 vector) {
    double norm = vector.norm();
    return norm == 0 ? Vec2.ZERO : vector.times(1 / norm);
  }
}
