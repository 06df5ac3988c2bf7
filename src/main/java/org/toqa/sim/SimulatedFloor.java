package org.toqa.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.grid.RayCast;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.link.message.AgentMessage.SeenBox;

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

  private final String name;

  /** Null: there are none, nor marks. */
  private volatile @Nullable OccupancyGrid walls;

  private volatile List<Vec2> chargers;
  private final Map<String, Solid> obstacles = new ConcurrentHashMap<>();
  private final Map<String, Solid> robots = new ConcurrentHashMap<>();
  private final SolidIndex solids = new SolidIndex();
  private final CarriedLoads carriedLoads = new CarriedLoads();

  /** By robot, metres that its cameras see. */
  private final Map<String, Double> cameras = new ConcurrentHashMap<>();

  private final Set<String> blind = ConcurrentHashMap.newKeySet();

  /** Null: no boxes are simulated. */
  private volatile @Nullable SimulatedBoxes boxes;

  private SimulatedFloor(String name, @Nullable OccupancyGrid walls, List<Vec2> chargers) {
    this.name = name;
    this.walls = walls;
    this.chargers = List.copyOf(chargers);
  }

  public static SimulatedFloor of(FloorMap floor) {
    return new SimulatedFloor(floor.name(), floor.drawing().walls(), chargers(floor));
  }

  private static List<Vec2> chargers(FloorMap floor) {
    return floor.charging().stream().map(Place::position).toList();
  }

  /** From now on walls and chargers are where this map has them. */
  public void rebuild(FloorMap floor) {
    walls = floor.drawing().walls();
    chargers = chargers(floor);
  }

  /** A floor without walls, marks and chargers. */
  public static SimulatedFloor boundless() {
    return new SimulatedFloor("", null, List.of());
  }

  String name() {
    return name;
  }

  /** Where robots that are stopped are charged now, metres, map frame. */
  List<Vec2> chargers() {
    return chargers;
  }

  /**
   * Puts an obstacle, or moves the one of that name.
   *
   * @param middle metres, map frame
   * @param radius metres
   */
  public synchronized void putObstacle(String obstacle, Vec2 middle, double radius) {
    Solid there = new Solid(new Pose(middle.x(), middle.y(), 0), radius);
    solids.add(there);
    removeSolid(obstacles.put(obstacle, there));
  }

  /** From now on these boxes are on it. */
  public void putBoxes(SimulatedBoxes there) {
    boxes = there;
    carriedLoads.setBoxes(there);
  }

  /**
   * A robot has cameras from now on.
   *
   * @param range metres that they see
   */
  void mountCamera(String robot, double range) {
    cameras.put(robot, range);
  }

  /** Fault switch: the cameras of a robot see nothing at all. */
  public void setCameraBlind(String robot, boolean isBlind) {
    if (isBlind) {
      blind.add(robot);
    } else {
      blind.remove(robot);
    }
  }

  /** What cameras see from there: what lies within their range and not behind walls. */
  private CameraView view(Vec2 from, double range) {
    SimulatedBoxes there = boxes;
    List<SeenBox> seen = new ArrayList<>();
    if (there != null) {
      there
          .lying()
          .forEach(
              (number, place) -> {
                if (isInView(from, place, range)) {
                  seen.add(new SeenBox(number, place));
                }
              });
    }
    return new CameraView(range, seen);
  }

  private boolean isInView(Vec2 from, Vec2 place, double range) {
    Vec2 ray = place.minus(from);
    double distance = ray.norm();
    return distance <= range
        && (distance < 1e-9
            || distanceToWall(new Pose(from.x(), from.y(), ray.angle()), distance)
                >= distance - 1e-9);
  }

  /** Takes an obstacle away. */
  public synchronized void removeObstacle(String obstacle) {
    removeSolid(obstacles.remove(obstacle));
  }

  private void removeSolid(@Nullable Solid gone) {
    if (gone != null) {
      solids.remove(gone);
    }
  }

  /** The robot is carried away; nothing lies on it, and what its hand held is left where it was. */
  void removeRobot(String robot) {
    Solid gone = robots.remove(robot);
    if (gone != null) {
      removeSolid(gone);
      carriedLoads.put(robot, null, gone.at());
      SimulatedBoxes there = boxes;
      if (there != null) {
        there.release(robot, gone.at().position());
      }
    }
  }

  /** Where the robot really is, map frame; empty where its body is not simulated as a whole. */
  Optional<Pose> truePose(String robot) {
    return Optional.ofNullable(robots.get(robot)).map(Solid::at);
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
  public Surroundings surroundings(String robot, double radius) {
    return new Surroundings() {
      private @Nullable Solid body;

      @Override
      public void setTruePose(Pose truth) {
        if (body == null) {
          body = new Solid(truth, radius);
          solids.add(body);
          removeSolid(robots.put(robot, body));
        } else {
          solids.move(body, truth);
        }
      }

      @Override
      public void setSharedLoad(@Nullable SharedLoad load) {
        if (body != null) {
          carriedLoads.put(robot, load, body.at());
        }
      }

      @Override
      public OptionalDouble borneShare() {
        return carriedLoads.shareOf(robot);
      }

      @Override
      public @Nullable CameraView view(Vec2 from) {
        Double range = cameras.get(robot);
        return range == null || blind.contains(robot)
            ? null
            : SimulatedFloor.this.view(from, range);
      }

      @Override
      public OptionalDouble grasp(Vec2 hand) {
        SimulatedBoxes there = boxes;
        return there == null ? OptionalDouble.empty() : OptionalDouble.of(there.grasp(robot, hand));
      }

      @Override
      public void release(Vec2 hand) {
        SimulatedBoxes there = boxes;
        if (there != null) {
          there.release(robot, hand);
        }
      }

      @Override
      public double distance(Pose ray, double farthest) {
        return solids.distance(ray, distanceToWall(ray, farthest), body);
      }

      @Override
      public boolean isMarked(Vec2 point) {
        return SimulatedFloor.this.isMarked(point);
      }
    };
  }

  private double distanceToWall(Pose ray, double farthest) {
    OccupancyGrid now = walls;
    return now == null ? farthest : RayCast.distance(now, ray.position(), ray.theta(), farthest);
  }

  private boolean isMarked(Vec2 point) {
    OccupancyGrid now = walls;
    return now != null
        && Math.hypot(
                distanceToMarkRow(point.x() - now.origin().x()),
                distanceToMarkRow(point.y() - now.origin().y()))
            < MARK_RANGE;
  }

  /** Metres to the nearest row of marks; the first is half their distance from the map's edge. */
  private static double distanceToMarkRow(double metres) {
    double rows = metres / MARK_DISTANCE - 0.5;
    return (rows - Math.rint(rows)) * MARK_DISTANCE;
  }
}
