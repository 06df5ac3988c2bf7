package org.toqa.sim;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * A rigid load as it truly lies on several robots. People lay it on them where it stands, turned as
 * it likes, when all of them have come; from then on it goes where friction takes it: to the place
 * from which the points at which it was laid on are nearest to the robots' hold points, by least
 * squares, each counted by its share. What each bears follows from where its hold point then is
 * under the load: see {@link SupportForces}.
 */
final class CarriedLoad {
  private static final double ROUNDING = 1e-6;

  private final double weight;
  private final Map<String, Support> supports = new HashMap<>();

  /** Who has told where it is since the shares were computed, in the tick that goes on. */
  private final Set<String> told = new HashSet<>();

  private Map<String, Double> shares = Map.of();

  /** Of the load's middle, map frame; the angle is how far it has turned since it was laid on. */
  private Pose at;

  /**
   * A robot under the load.
   *
   * @param point where it holds it, metres, map frame
   * @param touch where that was when the load was laid on, metres, in the load's frame; null: it
   *     was not yet
   */
  private record Support(double share, Vec2 point, @Nullable Vec2 touch) {}

  CarriedLoad(SharedLoad part) {
    weight = part.weight();
    at = new Pose(part.middle().x(), part.middle().y(), 0);
  }

  /**
   * A robot is under the load.
   *
   * @param truth where the robot really is, map frame
   */
  void put(String robot, SharedLoad part, Pose truth) {
    if (told.contains(robot)) {
      settle(); // all have told where they were a tick ago, but for who is silent
    }
    Support before = supports.get(robot);
    Vec2 touch = before == null ? null : before.touch();
    Vec2 point = truth.compose(new Pose(part.point().x(), part.point().y(), 0)).position();
    supports.put(robot, new Support(part.share(), point, touch));
    told.add(robot);
  }

  /**
   * A robot is no more under the load.
   *
   * @return whether nobody is
   */
  boolean takeAway(String robot) {
    supports.remove(robot);
    told.remove(robot);
    shares = Map.of();
    return supports.isEmpty();
  }

  /** Of the load, metres, map frame. */
  Vec2 middle() {
    return at.position();
  }

  OptionalDouble shareOf(String robot) {
    Double share = shares.get(robot);
    return share == null ? OptionalDouble.empty() : OptionalDouble.of(share);
  }

  /** The load moves with its robots, and weighs on them as they are now. */
  private void settle() {
    told.clear();
    double planned = supports.values().stream().mapToDouble(Support::share).sum();
    if (planned < weight - ROUNDING) {
      shares = Map.of(); // not all of them have come
      return;
    }
    move();
    supports.replaceAll((_, s) -> s.touch() == null ? laidOn(s) : s);
    List<String> robots = new ArrayList<>(supports.keySet());
    double[] kilograms =
        SupportForces.of(
            robots.stream().map(supports::get).map(s -> inLoad(s.point())).toList(),
            robots.stream().map(supports::get).map(Support::share).toList(),
            weight);
    Map<String, Double> next = new HashMap<>();
    for (int i = 0; i < kilograms.length; i++) {
      next.put(robots.get(i), kilograms[i]);
    }
    shares = next;
  }

  private Support laidOn(Support support) {
    return new Support(support.share(), support.point(), inLoad(support.point()));
  }

  private Vec2 inLoad(Vec2 point) {
    return at.relative(new Pose(point.x(), point.y(), 0)).position();
  }

  /** Rot(a) touch + t nearest to the points: a = atan2(sum s t' x p', sum s t' . p'). */
  private void move() {
    double sum = 0;
    Vec2 touched = Vec2.ZERO;
    Vec2 held = Vec2.ZERO;
    for (Support s : supports.values()) {
      if (s.touch() != null) {
        sum += s.share();
        touched = touched.plus(s.touch().times(s.share()));
        held = held.plus(s.point().times(s.share()));
      }
    }
    if (sum == 0) {
      return;
    }
    touched = touched.times(1 / sum);
    held = held.times(1 / sum);
    double cross = 0;
    double dot = 0;
    for (Support s : supports.values()) {
      if (s.touch() != null) {
        Vec2 from = s.touch().minus(touched);
        Vec2 to = s.point().minus(held);
        cross += s.share() * (from.x() * to.y() - from.y() * to.x());
        dot += s.share() * (from.x() * to.x() + from.y() * to.y());
      }
    }
    double turned = cross == 0 && dot == 0 ? at.theta() : Math.atan2(cross, dot);
    Vec2 middle = held.minus(touched.rotated(turned));
    at = new Pose(middle.x(), middle.y(), turned);
  }
}
