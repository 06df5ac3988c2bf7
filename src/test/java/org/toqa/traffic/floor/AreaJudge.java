package org.toqa.traffic.floor;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OneWay;
import org.toqa.grid.SpeedLimit;

/**
 * Looks where middles really are, and whether they keep to the directions and speeds of a floor's
 * areas. It knows the areas as they are drawn, and nothing else.
 */
final class AreaJudge {
  /** Metres that a robot may come back in an area in all while it is in it. */
  private static final double MOST_BACK = 0.05;

  /** Metres; who is nearer to an area's border may be outside. */
  private static final double BORDER = 0.002;

  private final List<OneWay> oneWay;
  private final List<OneWay> approaches;
  private final List<SpeedLimit> speedLimits;

  /** By robot and area: how far along its direction the robot has been in it, metres. */
  private final Map<String, Double> farthest = new HashMap<>();

  private final Map<String, Vec2> last = new HashMap<>();

  AreaJudge(MoveRules rules) {
    oneWay = rules.oneWay();
    approaches = rules.approaches();
    speedLimits = rules.speedLimits();
  }

  /** A robot that was put there. */
  void put(String robot, Vec2 middle) {
    last.put(robot, middle);
    farthest.keySet().removeIf(key -> key.startsWith(robot + " "));
  }

  /**
   * @param seconds since it was looked at last
   */
  void look(String robot, Vec2 middle, double seconds) {
    Vec2 before = last.getOrDefault(robot, middle);
    last.put(robot, middle);
    for (int i = 0; i < oneWay.size(); i++) {
      lookAtDirection(robot, robot + " " + i, middle, oneWay.get(i));
    }
    for (OneWay approach : approaches) {
      Vec2 way = middle.minus(before);
      boolean isEntering = !isIn(approach.area(), before) && isIn(approach.area(), middle);
      if (isEntering && dot(way, approach.direction().vector()) < 0.5 * way.norm()) {
        throw new AssertionError(robot + " comes into " + approach + " from " + before);
      }
    }
    for (SpeedLimit slow : speedLimits) {
      double speed = middle.minus(before).norm() / seconds;
      if (isIn(slow.area(), before) && isIn(slow.area(), middle) && speed > slow.speed() + 1e-6) {
        throw new AssertionError(robot + " drives at " + speed + " in " + slow);
      }
    }
  }

  private void lookAtDirection(String robot, String key, Vec2 middle, OneWay one) {
    if (!isIn(one.area(), middle)) {
      farthest.remove(key);
      return;
    }
    double along = dot(middle, one.direction().vector());
    double most = Math.max(along, farthest.getOrDefault(key, along));
    farthest.put(key, most);
    if (most - along > MOST_BACK) {
      throw new AssertionError(robot + " drives back at " + middle + " in " + one);
    }
  }

  private static boolean isIn(Area area, Vec2 point) {
    Vec2 inside = point.minus(area.low());
    return Math.min(inside.x(), area.width() - inside.x()) > BORDER
        && Math.min(inside.y(), area.height() - inside.y()) > BORDER;
  }

  private static double dot(Vec2 a, Vec2 b) {
    return a.x() * b.x() + a.y() * b.y();
  }
}
