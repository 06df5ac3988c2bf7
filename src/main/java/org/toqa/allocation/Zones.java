package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;
import static java.util.Comparator.comparingInt;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;

/**
 * A floor divided into strips across its longer side, one a robot, in the order of the robots'
 * parking points (Tanta, "Load-based allocation").
 */
final class Zones {
  private final Vec2 low;
  private final Vec2 high;
  private final boolean isAlongX;
  private final double begin;
  private final double width;
  private final List<Candidate> robots;

  /**
   * @param robots all of the floor, at least one
   */
  Zones(Vec2 low, Vec2 high, List<Candidate> robots) {
    this.low = low;
    this.high = high;
    Vec2 size = high.minus(low);
    isAlongX = size.x() >= size.y();
    begin = along(low);
    width = along(size) / robots.size();
    this.robots =
        robots.stream()
            .sorted(
                comparingDouble((Candidate r) -> along(r.parking()))
                    .thenComparing(Candidate::robot))
            .toList();
  }

  List<Zone> strips() {
    return IntStream.range(0, count())
        .mapToObj(
            zone ->
                new Zone(
                    robotOf(zone).robot(),
                    corner(low, begin + zone * width),
                    corner(high, begin + (zone + 1) * width)))
        .toList();
  }

  private Vec2 corner(Vec2 floor, double along) {
    return isAlongX ? new Vec2(along, floor.y()) : new Vec2(floor.x(), along);
  }

  int count() {
    return robots.size();
  }

  /** From 0; a point beyond the floor counts to the last zone on its side. */
  int zoneOf(Vec2 point) {
    return Math.clamp((long) Math.floor((along(point) - begin) / width), 0, count() - 1);
  }

  /** The robot that parks in the zone. */
  Candidate robotOf(int zone) {
    return robots.get(zone);
  }

  /** The zone that is the robot's. */
  int zoneOfRobot(Candidate robot) {
    return robots.indexOf(robot);
  }

  /**
   * The zone of the point, the ones beside it, and so on outward; of two that are as far, the one
   * whose middle is nearer to the point.
   */
  List<Integer> outwardFrom(Vec2 point) {
    int home = zoneOf(point);
    Comparator<Integer> byRing = comparingInt(zone -> Math.abs(zone - home));
    return IntStream.range(0, count())
        .boxed()
        .sorted(byRing.thenComparingDouble(zone -> Math.abs(middle(zone) - along(point))))
        .toList();
  }

  private double middle(int zone) {
    return begin + (zone + 0.5) * width;
  }

  private double along(Vec2 point) {
    return isAlongX ? point.x() : point.y();
  }
}
