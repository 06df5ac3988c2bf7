package org.toqa.lab.fouragents;

import org.toqa.geometry.Vec2;

/**
 * A round obstacle that goes to and fro between two points and yields to nobody.
 *
 * @param radius metres
 * @param from metres, where it is at first
 * @param to metres
 * @param speed metres a second
 */
record MovingDisc(double radius, Vec2 from, Vec2 to, double speed) {

  /**
   * Where its middle is.
   *
   * @param time seconds since the beginning
   */
  Vec2 at(double time) {
    double length = from.distanceTo(to);
    double driven = speed * time % (2 * length);
    double share = (driven <= length ? driven : 2 * length - driven) / length;
    return from.plus(to.minus(from).times(share));
  }
}
