package org.toqa.geometry;

/**
 * A curve in the plane with a parameter u from 0 to {@link #end}, twice differentiable.
 *
 * <p>Points are metres in a fixed frame; derivatives are by u.
 */
public interface PlaneCurve {
  /** The last parameter, above 0. */
  double end();

  /** The point at a parameter from 0 to the end, metres. */
  Vec2 position(double u);

  /** The first derivative there. */
  Vec2 velocity(double u);

  /** The second derivative there. */
  Vec2 acceleration(double u);

  /** Curvature there, radians a metre, positive to the left. */
  default double curvature(double u) {
    // kappa = (x' y'' - y' x'') / (x'^2 + y'^2)^(3/2)
    Vec2 first = velocity(u);
    Vec2 second = acceleration(u);
    double speed = first.norm();
    return (first.x() * second.y() - first.y() * second.x()) / (speed * speed * speed);
  }
}
