package org.toqa.geometry;

/**
 * Where something is and with which heading, in a fixed frame (for a robot: the map's).
 *
 * @param x metres, to the east
 * @param y metres, to the north
 * @param theta radians, counter-clockwise from east, in (-pi, pi]
 */
public record Pose(double x, double y, double theta) {

  public Pose {
    theta = Angles.normalise(theta);
  }

  /** Metres, in the same frame. */
  public Vec2 position() {
    return new Vec2(x, y);
  }

  /**
   * This pose, seen as a frame, followed by a pose inside that frame.
   *
   * @return in the frame of this pose
   */
  public Pose compose(Pose inside) {
    Vec2 p = inside.position().rotated(theta);
    return new Pose(x + p.x(), y + p.y(), theta + inside.theta);
  }

  /**
   * The pose {@code p} with {@code compose(p)} equal to {@code other}: the other seen from here.
   *
   * @param other in the same frame as this
   * @return in this pose's own frame: x forward, y left
   */
  public Pose relative(Pose other) {
    Vec2 p = other.position().minus(position()).rotated(-theta);
    return new Pose(p.x(), p.y(), other.theta - theta);
  }

  /**
   * The pose after moving with constant velocity: the exact arc, not a chord.
   *
   * @param twist in this pose's own frame
   * @param seconds how long; backward in time below 0
   * @return in the frame of this pose
   */
  public Pose advanced(Twist twist, double seconds) {
    double turn = twist.w() * seconds;
    // integral of (cos, sin) over the turn; the series where the quotient would cancel
    double sinc = Math.abs(turn) < 1e-6 ? 1 - turn * turn / 6 : Math.sin(turn) / turn;
    double cosc = Math.abs(turn) < 1e-6 ? turn / 2 : (1 - Math.cos(turn)) / turn;
    double dx = (twist.vx() * sinc - twist.vy() * cosc) * seconds;
    double dy = (twist.vx() * cosc + twist.vy() * sinc) * seconds;
    return compose(new Pose(dx, dy, turn));
  }

  /** Metres between the two positions. */
  public double distanceTo(Pose other) {
    return Math.hypot(x - other.x, y - other.y);
  }
}
