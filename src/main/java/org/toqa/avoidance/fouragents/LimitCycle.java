package org.toqa.avoidance.fouragents;

import org.toqa.geometry.Vec2;

/**
 * A field of directions whose trajectories run into a circle and stay on it, seen from its centre:
 *
 * <pre>
 * clockwise          xs' =  ys + mu xs (Rc^2 - xs^2 - ys^2),  ys' = -xs + mu ys (Rc^2 - xs^2 - ys^2)
 * counter-clockwise  xs' = -ys + mu xs (Rc^2 - xs^2 - ys^2),  ys' =  xs + mu ys (Rc^2 - xs^2 - ys^2)
 * </pre>
 *
 * <p>In polar coordinates r' = mu r (Rc^2 - r^2) and the angle turns by 1 rad/s, so from every
 * point but the centre r(t)^2 = Rc^2 / (1 + (Rc^2 / r0^2 - 1) exp(-2 mu Rc^2 t)). mu has the unit
 * 1/(m^2 s): a constant one makes small circles slack and large ones stiff. Here mu = convergence /
 * Rc^2, which gives all circles the same shape. Times of the field mean nothing: the robot drives
 * along it at its own speed.
 *
 * @param radius Rc, metres
 * @param convergence mu Rc^2, above 0: how fast trajectories come to the circle
 * @param isClockwise which way round
 */
public record LimitCycle(double radius, double convergence, boolean isClockwise) {

  /**
   * The field's velocity at a point.
   *
   * @param at metres from the centre, in a frame of any heading
   * @return in the same frame, per unit of the field's time
   */
  public Vec2 velocity(Vec2 at) {
    double pull = pull(at);
    double turn = isClockwise ? 1 : -1;
    return new Vec2(turn * at.y() + pull * at.x(), -turn * at.x() + pull * at.y());
  }

  // mu (Rc^2 - xs^2 - ys^2)
  private double pull(Vec2 at) {
    return convergence * (1 - (at.x() * at.x() + at.y() * at.y()) / (radius * radius));
  }

  /** Curvature of the trajectory through a point, radians a metre, positive to the left. */
  public double curvature(Vec2 at) {
    // f' along the trajectory: J f, with J the field's derivative by the place
    Vec2 f = velocity(at);
    double pull = pull(at);
    double turn = isClockwise ? 1 : -1;
    double slope = -2 * convergence / (radius * radius); // d pull / dx = slope x
    double along = at.x() * f.x() + at.y() * f.y();
    double ax = turn * f.y() + pull * f.x() + slope * along * at.x();
    double ay = -turn * f.x() + pull * f.y() + slope * along * at.y();
    double speed = f.norm();
    return speed < 1e-12 ? 0 : (f.x() * ay - f.y() * ax) / (speed * speed * speed);
  }
}
