package org.toqa.avoidance;

import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * How far a robot that can go sideways drives beside its path, by {@link WeightedDirections}: it
 * yields to what is at the edge of its corridor, and comes back behind it.
 */
public final class Sidestep {

  /**
   * Metres: on the shipped map robots of 0.255 m drive in cells of 0.30 m, and what is beside that
   * cell is a wall or another's. Half of that room is left for how exactly they drive.
   */
  public static final double MAX_OFFSET = 0.01;

  /** Metres to the point of the path that pulls. */
  private static final double LOOKAHEAD = 0.30;

  /** Metres before the end of the path within which it is back on it. */
  private static final double RETURN_DISTANCE = 0.30;

  /** Metres; less than this is on the path. */
  private static final double ON_PATH = 0.0002;

  private double offset;
  private double rate;

  /**
   * Lets time go on.
   *
   * @param pose on the path, map frame
   * @param speed metres a second, along the path
   * @param beside what is to be passed, map frame
   * @param distanceLeft metres to the end of the path
   * @param seconds since the last step, at least 0
   */
  public void step(
      Pose pose, double speed, List<Vec2> beside, double distanceLeft, double seconds) {
    if (offset == 0 && beside.isEmpty()) {
      rate = 0;
      return;
    }
    Vec2 here = new Vec2(0, offset);
    List<Vec2> seen =
        beside.stream()
            .map(point -> point.minus(pose.position()).rotated(-pose.theta()).minus(here))
            .toList();
    Vec2 direction = WeightedDirections.direction(new Vec2(LOOKAHEAD, 0).minus(here), seen);
    double norm = direction.norm();
    double sideways = norm == 0 ? 0 : Math.abs(speed) * direction.y() / norm;
    double most = MAX_OFFSET * Math.clamp(distanceLeft / RETURN_DISTANCE, 0, 1);
    double next = Math.clamp(offset + sideways * seconds, -most, most);
    next = beside.isEmpty() && Math.abs(next) < ON_PATH ? 0 : next;
    rate = seconds > 0 ? (next - offset) / seconds : 0;
    offset = next;
  }

  /** Metres to the left of the path. */
  public double offset() {
    return offset;
  }

  /** Whether it drives on the path itself. */
  public boolean isOnPath() {
    return offset == 0 && rate == 0;
  }

  /**
   * Where the robot shall be.
   *
   * @param onPath where it would be on its path, in any frame
   */
  public Pose beside(Pose onPath) {
    return offset == 0 ? onPath : onPath.compose(new Pose(0, offset, 0));
  }

  /**
   * How the robot shall move, in its own frame.
   *
   * @param onPath how it would move on its path, in its own frame
   */
  public Twist beside(Twist onPath) {
    // beside a point that turns, every point moves by w x r
    return isOnPath()
        ? onPath
        : new Twist(onPath.vx() - onPath.w() * offset, onPath.vy() + rate, onPath.w());
  }
}
