package org.toqa.planning.smooth;

import java.util.random.RandomGenerator;

/**
 * Points that a path shorter than the best one may go through: they lie in an ellipse whose foci
 * are start and goal (Gammell, Srinivasa and Barfoot, "Informed RRT*", 2014), and on the grid.
 */
final class InformedSampler {
  private final RandomGenerator random;
  private final double width;
  private final double height;
  private final double middleX;
  private final double middleY;
  private final double cos;
  private final double sin;
  private final double direct;
  private double best = Double.POSITIVE_INFINITY;
  private double x;
  private double y;

  InformedSampler(DiscSpace space, WayPoints ends, RandomGenerator random) {
    this.random = random;
    this.width = space.width();
    this.height = space.height();
    double alongX = ends.x(1) - ends.x(0);
    double alongY = ends.y(1) - ends.y(0);
    this.middleX = (ends.x(0) + ends.x(1)) / 2;
    this.middleY = (ends.y(0) + ends.y(1)) / 2;
    this.direct = Math.hypot(alongX, alongY);
    this.cos = alongX / direct;
    this.sin = alongY / direct;
  }

  /** A path of so many cells is known: longer ones are of no use. */
  void setBest(double length) {
    best = Math.max(length, direct);
  }

  /** The area in which it samples, square cells; an upper bound. */
  double area() {
    double whole = width * height;
    return best == Double.POSITIVE_INFINITY
        ? whole
        : Math.min(whole, Math.PI / 4 * best * Math.sqrt(best * best - direct * direct));
  }

  /** Draws the next point. */
  void draw() {
    double around =
        best == Double.POSITIVE_INFINITY
            ? Double.POSITIVE_INFINITY
            : best * Math.sqrt(best * best - direct * direct);
    if (around >= width * height) {
      do {
        x = random.nextDouble() * width;
        y = random.nextDouble() * height;
      } while (!mayShorten(x, y));
      return;
    }
    do {
      drawInEllipse();
    } while (!(x >= 0 && y >= 0 && x <= width && y <= height));
  }

  private void drawInEllipse() {
    double u;
    double v;
    do {
      u = 2 * random.nextDouble() - 1;
      v = 2 * random.nextDouble() - 1;
    } while (u * u + v * v > 1);
    double along = u * best / 2;
    double across = v * Math.sqrt(best * best - direct * direct) / 2;
    x = middleX + along * cos - across * sin;
    y = middleY + along * sin + across * cos;
  }

  /** Whether a path through a point may be shorter than the best one. */
  boolean mayShorten(double pointX, double pointY) {
    if (best == Double.POSITIVE_INFINITY) {
      return true;
    }
    double halfX = direct / 2 * cos;
    double halfY = direct / 2 * sin;
    return WayPoints.distance(middleX - halfX, middleY - halfY, pointX, pointY)
            + WayPoints.distance(middleX + halfX, middleY + halfY, pointX, pointY)
        <= best + DiscSpace.TOLERANCE;
  }

  /** Of the point drawn last, cells. */
  double x() {
    return x;
  }

  /** Of the point drawn last, cells. */
  double y() {
    return y;
  }
}
