package org.toqa.formation.swarm;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.ToDoubleFunction;
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
    Vec2 leader = VirtualLeader.position(robots);
    List<Vec2> places =
        robots.stream().map(r -> VirtualLeader.inFrame(r.position(), leader, direction)).toList();
    List<Integer> rest = new ArrayList<>();
    for (int i = 0; i < places.size(); i++) {
      rest.add(i);
    }
    if (rest.size() == 1) {
      return new Observers(OptionalInt.empty(), OptionalInt.of(0), OptionalInt.empty());
    }
    OptionalInt left = take(rest, places, Vec2::y, Vec2::x, width);
    OptionalInt right = take(rest, places, p -> -p.y(), Vec2::x, width);
    return new Observers(left, take(rest, places, Vec2::x, p -> -Math.abs(p.y()), width), right);
  }

  /** The best by one measure, and of its equals by another; it is taken out of the rest. */
  private static OptionalInt take(
      List<Integer> rest,
      List<Vec2> places,
      ToDoubleFunction<Vec2> first,
      ToDoubleFunction<Vec2> second,
      double width) {
    double most =
        rest.stream().mapToDouble(i -> first.applyAsDouble(places.get(i))).max().orElse(0);
    OptionalInt best = OptionalInt.empty();
    for (int i : rest) {
      boolean isEqual = most - first.applyAsDouble(places.get(i)) < width / 2;
      if (isEqual
          && (best.isEmpty()
              || second.applyAsDouble(places.get(i))
                  > second.applyAsDouble(places.get(best.getAsInt())))) {
        best = OptionalInt.of(i);
      }
    }
    best.ifPresent(i -> rest.remove(Integer.valueOf(i)));
    return best;
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
