package org.toqa.formation.swarm;

import java.util.List;
import java.util.OptionalInt;
import org.toqa.geometry.Vec2;

/**
 * The robots whose lidars are on, as indices of the swarm's list; all others are off.
 *
 * <p>Left is the largest y', right the smallest, ties by the larger x'; middle the largest x', ties
 * by the smaller |y'|. Coordinates that differ by less than half a robot's width are equal. Who is
 * left or right is not the middle as well: the next best one is. One robot alone is the middle, two
 * are left and right. The paper does not say who is right where one robot is both leftmost and
 * rightmost, in a column: here the next best one.
 */
public record Observers(OptionalInt left, OptionalInt middle, OptionalInt right) {

  /**
   * @param robots of the swarm
   * @param direction of motion, radians, counter-clockwise from map east
   * @param width of a robot, metres
   */
  public static Observers of(List<SwarmRobot> robots, double direction, double width) {
    if (robots.isEmpty()) {
      return new Observers(OptionalInt.empty(), OptionalInt.empty(), OptionalInt.empty());
    }
    int count = robots.size();
    if (count == 1) {
      return new Observers(OptionalInt.empty(), OptionalInt.of(0), OptionalInt.empty());
    }
    Vec2 leader = VirtualLeader.position(robots);
    double[] ahead = new double[count];
    double[] left = new double[count];
    double[] right = new double[count];
    double[] central = new double[count];
    for (int i = 0; i < count; i++) {
      Vec2 place = VirtualLeader.inFrame(robots.get(i).position(), leader, direction);
      ahead[i] = place.x();
      left[i] = place.y();
      right[i] = -place.y();
      central[i] = -Math.abs(place.y());
    }
    boolean[] taken = new boolean[count];
    OptionalInt leftmost = take(taken, left, ahead, width);
    OptionalInt rightmost = take(taken, right, ahead, width);
    return new Observers(leftmost, take(taken, ahead, central, width), rightmost);
  }

  /** The best by one measure, and of its equals by another; no one is taken twice. */
  private static OptionalInt take(boolean[] taken, double[] first, double[] second, double width) {
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < taken.length; i++) {
      most = taken[i] ? most : Math.max(most, first[i]);
    }
    int best = -1;
    for (int i = 0; i < taken.length; i++) {
      boolean isEqual = !taken[i] && most - first[i] < width / 2;
      if (isEqual && (best < 0 || second[i] > second[best])) {
        best = i;
      }
    }
    if (best < 0) {
      return OptionalInt.empty();
    }
    taken[best] = true;
    return OptionalInt.of(best);
  }

  /** How many lidars are on. */
  public int count() {
    return (int) List.of(left, middle, right).stream().filter(OptionalInt::isPresent).count();
  }

  /**
   * The part of the lidars' energy that is saved: (N - 3) / N, and none below three robots.
   *
   * @param robots N, at least 1
   */
  public static double saving(int robots) {
    return Math.max(0, robots - 3) / (double) robots;
  }
}
