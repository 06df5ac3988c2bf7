package org.toqa.lab.cmct;

import org.toqa.geometry.Vec2;

/**
 * CMCT-PP to the letter: the step from which the remaining distance is the largest, and a total
 * {@code D_t} of the remaining distances instead of the steps.
 *
 * @param arrives whether the target is reached within a thousand steps
 * @param total D_t, metres
 * @param length of the steps, metres
 */
record PrintedRule(boolean arrives, double total, double length) {
  private static final int MOST_STEPS = 1000;
  private static final double ROUNDING = 1e-6;

  /**
   * Without obstacles, from the origin to a target.
   *
   * @param target metres, both above 0: signs are left out in the paper
   * @param takesSmallest the erratum: the smallest remaining distance instead of the largest
   */
  static PrintedRule of(Vec2 target, boolean takesSmallest) {
    double stepX = target.x() / 10;
    double stepY = target.y() / 10;
    Vec2[] steps = {new Vec2(stepX, 0), new Vec2(stepX, stepY), new Vec2(0, stepY)};
    Vec2 here = Vec2.ZERO;
    double total = 0;
    double length = 0;
    for (int i = 0; i < MOST_STEPS; i++) {
      // D1 = sqrt((Xf - Xm1 - Cx)^2 + (Yf - Ym1)^2), and D2, D3 alike, after Xm1 = Xm1 + Cx
      double[] left = new double[3];
      for (int path = 0; path < 3; path++) {
        left[path] = target.minus(here.plus(steps[path].times(2))).norm();
        left[path] = takesSmallest ? -left[path] : left[path];
      }
      int taken = left[0] > left[1] && left[0] > left[2] ? 0 : left[1] > left[2] ? 1 : 2;
      taken = taken == 1 && left[1] <= left[0] ? 2 : taken;
      here = here.plus(steps[taken]);
      total += Math.abs(left[taken]);
      length += steps[taken].norm();
      if (here.distanceTo(target) < ROUNDING) {
        return new PrintedRule(true, total, length);
      }
    }
    return new PrintedRule(false, total, length);
  }
}
