package org.toqa.sim;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.grid.RayCast;

/**
 * The one world of all simulated robots: walls, the robots themselves, and obstacles that anybody
 * may put, move and take away at any time. Everything but walls is round. May be used by any
 * thread.
 *
 * <p>Small marks lie in rows on the floor, as the codes in the floors of warehouses: a robot over
 * one reads where it is. Without them odometry alone would take a robot into the walls within
 * minutes.
 */
public final class SimulatedFloor {

  /** Metres from mark to mark, in both directions. */
  private static final double MARK_DISTANCE = 0.30;

  /** Metres round a mark from where it is read. */
  private static final double MARK_RANGE = 0.05;

  /** Null: there are none, nor marks. */
  private final @Nullable OccupancyGrid walls;

  private final List<Vec2> chargers;
  private final Map<String, Disc> obstacles = new ConcurrentHashMap<>();
  private final Map<String, Disc> robots = new ConcurrentHashMap<>();

  /**
   * @param at map frame
   * @param radius metres
   */
  private record Disc(Pose at, double radius) {

    /** Metres along a ray until it meets the disc; beyond {@code farthest} anything above that. */
    double distance(Pose ray, double farthest) {
      double x = at.x() - ray.x();
      double y = at.y() - ray.y();
      double reach = farthest + radius;
      if (Math.abs(x) > reach || Math.abs(y) > reach) {
        return Double.POSITIVE_INFINITY;
      }
      double cos = Math.cos(ray.theta());
      double sin = Math.sin(ray.theta());
      double along = x * cos + y * sin;
      double aside = y * cos - x * sin;
      double half = radius * radius - aside * aside;
      if (half <= 0 || along + Math.sqrt(half) < 0) {
        return Double.POSITIVE_INFINITY;
      }
      return Math.max(0, along - Math.sqrt(half));
    }
  }

  private SimulatedFloor(@Nullable OccupancyGrid walls, List<Vec2> chargers) {
    this.walls = walls;
    this.chargers = List.copyOf(chargers);
  }

  public static SimulatedFloor of(FloorMap floor) {
    return new SimulatedFloor(
        floor.grid(), floor.charging().stream().map(Place::position).toList());
  }

  /** A floor without walls, marks and chargers. */
  public static SimulatedFloor boundless() {
    return new SimulatedFloor(null, List.of());
  }

  /** Where robots that are stopped are charged, metres, map frame. */
  List<Vec2> chargers() {
    return chargers;
  }

  /**
   * Puts an obstacle, or moves the one of that name.
   *
   * @param middle metres, map frame
   * @param radius metres
   */
  public void putObstacle(String obstacle, Vec2 middle, double radius) {
    obstacles.put(obstacle, new Disc(new Pose(middle.x(), middle.y(), 0), radius));
  }

  /** Takes an obstacle away. */
  public void removeObstacle(String obstacle) {
    obstacles.remove(obstacle);
  }

  /** Where the robot really is, map frame; empty where its body is not simulated as a whole. */
  Optional<Pose> truePose(String robot) {
    return Optional.ofNullable(robots.get(robot)).map(Disc::at);
  }

  /** The robots whose bodies are simulated as a whole, where they really are. */
  List<Body> bodies() {
    return robots.entrySet().stream()
        .map(r -> Body.disc(r.getKey(), r.getValue().at().position(), r.getValue().radius()))
        .toList();
  }

  /**
   * What a robot finds round it.
   *
   * @param radius of that robot, metres
   */
  Surroundings surroundings(String robot, double radius) {
    return new Surroundings() {
      @Override
      public void setTruePose(Pose truth) {
        robots.put(robot, new Disc(truth, radius));
      }

      @Override
      public double distance(Pose ray, double farthest) {
        double nearest = distanceToWall(ray, farthest);
        for (Disc obstacle : obstacles.values()) {
          nearest = Math.min(nearest, obstacle.distance(ray, nearest));
        }
        for (Map.Entry<String, Disc> other : robots.entrySet()) {
          if (!other.getKey().equals(robot)) {
            nearest = Math.min(nearest, other.getValue().distance(ray, nearest));
          }
        }
        return nearest;
      }

      @Override
      public boolean isMarked(Vec2 point) {
        return SimulatedFloor.this.isMarked(point);
      }
    };
  }

  private double distanceToWall(Pose ray, double farthest) {
    return walls == null
        ? farthest
        : RayCast.distance(walls, ray.position(), ray.theta(), farthest);
  }

  private boolean isMarked(Vec2 point) {
    return walls != null
        && Math.hypot(
                distanceToMarkRow(point.x() - walls.origin().x()),
                distanceToMarkRow(point.y() - walls.origin().y()))
            < MARK_RANGE;
  }

  /** Metres to the nearest row of marks; the first is half their distance from the map's edge. */
  private static double distanceToMarkRow(double metres) {
    double rows = metres / MARK_DISTANCE - 0.5;
    return (rows - Math.rint(rows)) * MARK_DISTANCE;
  }
}
