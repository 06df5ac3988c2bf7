package org.toqa.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.toqa.avoidance.Encounter.TimedPoint;
import org.toqa.geometry.Vec2;

/**
 * How fast a robot may go on along its path among discs that move, so that it never drives into
 * one: it goes on only if it could brake after that, and stand before any contact (passive motion
 * safety: Macek et al., "Towards safe vehicle navigation in dynamic urban scenarios", 2009;
 * Bouraine, Fraichard and Salhi, "Provably safe navigation for mobile robots with limited field-of-
 * views in unknown dynamic environments", 2012). Who stands may still be driven into.
 *
 * <p>By induction: braking from the present speed was found free at the last sample, or the robot
 * stood. A faster or equal speed is taken only where braking after it is free too. Where none is,
 * the robot brakes as it was found free to do.
 *
 * @param radius metres, of the robot with what it may be off its path
 * @param acceleration metres a second squared, of braking and of speeding up, above 0
 * @param sample seconds for which a speed holds
 */
public record SafePace(double radius, double acceleration, double sample) {
  /** Speeds that are tried between the most and the least. */
  private static final int CHOICES = 6;

  /**
   * The speed of the next sample: the fastest that is safe, or the slowest that can be reached.
   *
   * @param path where the robot is so many metres ahead, map frame
   * @param speed metres a second, now
   * @param wanted metres a second, not below 0
   * @param obstacles as they are now
   */
  public double next(
      DoubleFunction<Vec2> path, double speed, double wanted, List<MovingDisc> obstacles) {
    double slowest = Math.max(0, speed - acceleration * sample);
    double fastest = Math.max(slowest, Math.min(wanted, speed + acceleration * sample));
    for (int choice = CHOICES; choice > 0; choice--) {
      double tried = slowest + (fastest - slowest) * choice / CHOICES;
      if (isSafe(path, tried, obstacles)) {
        return tried;
      }
    }
    return slowest;
  }

  /** Whether the robot may drive a sample at a speed, brake, and stand before any contact. */
  public boolean isSafe(DoubleFunction<Vec2> path, double speed, List<MovingDisc> obstacles) {
    if (speed == 0) {
      return true;
    }
    return Encounter.first(braking(path, speed), radius, obstacles).isEmpty();
  }

  /** A sample at a speed, and then a lower speed each sample. */
  private List<TimedPoint> braking(DoubleFunction<Vec2> path, double speed) {
    List<TimedPoint> motion = new ArrayList<>();
    double metres = 0;
    double seconds = 0;
    motion.add(new TimedPoint(0, path.apply(0)));
    for (double v = speed; v > 0; v -= acceleration * sample) {
      metres += v * sample;
      seconds += sample;
      motion.add(new TimedPoint(seconds, path.apply(metres)));
    }
    return motion;
  }
}
