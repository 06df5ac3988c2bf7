package org.toqa.driving;

import java.util.ArrayList;
import java.util.List;
import org.toqa.avoidance.Encounter.TimedPoint;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;

/**
 * How fast a line may be driven at each place, by its bends and by the stop at its end, from any
 * speed that a robot has already: unlike {@link org.toqa.motion.VelocityPlanner}, which plans from
 * rest to rest and bounds the jerk too, this is asked sample by sample, by a robot that may have to
 * slow down for others.
 */
public final class LineSpeeds {
  /** Metres between places. */
  private static final double APART = 0.005;

  /** Share of the acceleration by which bends and the end are braked for: the rest is reserve. */
  private static final double BRAKING = 0.8;

  private final DrivenLine line;
  private final DifferentialLimits limits;

  /** By place, metres a second. */
  private final double[] fastest;

  public LineSpeeds(DrivenLine line, DifferentialLimits limits) {
    this.line = line;
    this.limits = limits;
    int places = (int) Math.ceil(line.length() / APART) + 1;
    fastest = new double[places];
    double growth = 2 * BRAKING * limits.acceleration() * APART;
    for (int i = places - 2; i >= 0; i--) {
      // v^2 grows by at most 2 a s, from the end on
      fastest[i] =
          Math.min(
              limits.speedAt(line.curvature(i * APART)),
              Math.sqrt(fastest[i + 1] * fastest[i + 1] + growth));
    }
  }

  /** The most after so many metres, metres a second; 0 at the end. */
  public double at(double metres) {
    int place = (int) Math.floor(metres / APART);
    return place >= fastest.length ? 0 : fastest[Math.max(0, place)];
  }

  /**
   * The speed of the next sample if nobody is in the way.
   *
   * @param metres driven already
   * @param speed metres a second, now
   */
  public double next(double metres, double speed) {
    // the last millimetres are driven at the speed that is stopped from in a sample
    double step = limits.acceleration() * WheelCommand.SAMPLE;
    double fast = Math.min(speed + step, at(metres));
    double allowed = Math.max(step, Math.min(fast, at(metres + fast * WheelCommand.SAMPLE)));
    double left = Math.max(0, line.length() - metres) / WheelCommand.SAMPLE;
    return Math.min(left, Math.clamp(allowed, Math.max(0, speed - step), speed + step));
  }

  /**
   * Where the robot will be if nobody is in the way.
   *
   * @param metres driven already
   * @param speed metres a second, now
   * @param seconds how far ahead
   */
  public List<TimedPoint> motion(double metres, double speed, double seconds) {
    List<TimedPoint> motion = new ArrayList<>();
    double at = metres;
    double v = speed;
    motion.add(new TimedPoint(0, line.at(at).position()));
    for (double time = WheelCommand.SAMPLE;
        time <= seconds && at < line.length();
        time += WheelCommand.SAMPLE) {
      v = next(at, v);
      at += v * WheelCommand.SAMPLE;
      motion.add(new TimedPoint(time, line.at(at).position()));
    }
    return motion;
  }
}
