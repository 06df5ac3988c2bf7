package org.toqa.forecast;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * What a robot drives from one place to another.
 *
 * @param metres of its path, at least 0; infinite: there is none
 * @param radians that it turns on the way, at least 0
 */
public record Drive(double metres, double radians) {
  /** To where the robot is. */
  public static final Drive NONE = new Drive(0, 0);

  /** To where it cannot come. */
  public static final Drive IMPOSSIBLE = new Drive(Double.POSITIVE_INFINITY, 0);

  /** Steps that are shorter, metres, have no direction. */
  private static final double SHORTEST_STEP = 0.001;

  /**
   * Along a line.
   *
   * @param line points, metres, map frame
   * @param heading of the robot where it begins, radians, counter-clockwise, map frame; null: along
   *     the line
   */
  public static Drive along(List<Vec2> line, @Nullable Double heading) {
    double metres = 0;
    double radians = 0;
    Double facing = heading;
    for (int i = 1; i < line.size(); i++) {
      Vec2 step = line.get(i).minus(line.get(i - 1));
      if (step.norm() < SHORTEST_STEP) {
        continue;
      }
      metres += step.norm();
      if (facing != null) {
        radians += Math.abs(Math.IEEEremainder(step.angle() - facing, 2 * Math.PI));
      }
      facing = step.angle();
    }
    return new Drive(metres, radians);
  }

  /** This one and then that. */
  public Drive plus(Drive next) {
    return new Drive(metres + next.metres, radians + next.radians);
  }

  public boolean isPossible() {
    return Double.isFinite(metres);
  }

  /**
   * How long it takes a robot that nobody hinders, seconds.
   *
   * @param speed metres a second, straight on
   * @param turnRate radians a second, on the spot
   */
  public double seconds(double speed, double turnRate) {
    return metres / speed + radians / turnRate;
  }
}
