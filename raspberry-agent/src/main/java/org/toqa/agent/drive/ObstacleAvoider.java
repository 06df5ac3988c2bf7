package org.toqa.agent.drive;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.avoidance.Corridor;
import org.toqa.avoidance.DetectionMemory;
import org.toqa.avoidance.Passage;
import org.toqa.avoidance.RangeSensors;
import org.toqa.avoidance.ScanTurn;
import org.toqa.avoidance.Sidestep;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.motion.DriveKind;

/**
 * Watches the path that a robot is about to drive: lets it pass beside an obstacle that only
 * reaches in, stops it before one that is on the path, and turns it a little to see how wide that
 * is. A leader only stops.
 */
public final class ObstacleAvoider {

  private static final Passage FREE_PASSAGE =
      new Passage(List.of(), List.of(), Double.POSITIVE_INFINITY);

  /** Metres round a point that blocks the path: what is seen there belongs to the same obstacle. */
  private static final double SAME_OBSTACLE_METRES = 0.5;

  /** Metres; with less room than this it stays stopped. */
  private static final double STOP_DISTANCE = 0.02;

  private final double radius;
  private final double mostAside;
  private final RangeSensors sensors;
  private final DetectionMemory blockingSightings = new DetectionMemory();
  private final DetectionMemory nearSightings = new DetectionMemory();
  private final Sidestep sidestep = new Sidestep();
  private final ScanTurn glance = new ScanTurn();
  private List<Vec2> newSightings = List.of();
  private double now;
  private Passage passage = FREE_PASSAGE;

  /**
   * @param radius of the robot, metres
   * @param kind of the robot: one that cannot go sideways stops before what is beside its path, too
   *     near to it
   */
  public ObstacleAvoider(double radius, DriveKind kind) {
    this.radius = radius;
    this.mostAside = kind.canGoSideways() ? Sidestep.MAX_OFFSET : 0;
    this.sensors = new RangeSensors(radius);
  }

  /**
   * To be called first in every tick.
   *
   * @param ranges metres, in the order of the range sensors
   * @param pose where the robot is, map frame
   * @param seconds on a monotonic clock
   */
  public void observe(List<Double> ranges, Pose pose, double seconds) {
    now = seconds;
    blockingSightings.forgetOld(now);
    nearSightings.forgetOld(now);
    newSightings = sensors.detections(ranges, pose);
    passage = FREE_PASSAGE;
  }

  /**
   * Looks along the trajectory, and slows it down before obstacles.
   *
   * @param seconds since the last call
   * @param onward whether the robot may move
   */
  public void avoidObstacles(ReferenceTrajectory trajectory, double seconds, boolean onward) {
    List<Vec2> seen = sightedPoints();
    if (!seen.isEmpty() || !sidestep.isOnPath() || !glance.isStraight()) {
      Corridor corridor = updatePassage(trajectory, seen);
      sidestep.step(
          trajectory.pose(), trajectory.twist().vx(), passage.beside(), corridor.length(), seconds);
      if (onward) {
        glance.step(isStopped() && trajectory.isStanding(), seconds);
      } else {
        glance.hold();
      }
    }
    trajectory.stopWithin(glance.isStraight() ? passage.freeDistance() : 0);
  }

  /** The same for a leader, which has a load beside it: it neither steps aside nor turns. */
  public void stopForObstacles(ReferenceTrajectory trajectory) {
    List<Vec2> seen = sightedPoints();
    if (!seen.isEmpty()) {
      updatePassage(trajectory, seen);
    }
    trajectory.stopWithin(passage.freeDistance());
  }

  /** Whether something that is seen decides now where and how fast the robot drives. */
  public boolean isActive() {
    return passage.freeDistance() < Double.POSITIVE_INFINITY
        || !passage.beside().isEmpty()
        || !sidestep.isOnPath()
        || !glance.isStraight();
  }

  private List<Vec2> sightedPoints() {
    return blockingSightings.isEmpty()
        ? newSightings
        : Stream.concat(blockingSightings.points().stream(), newSightings.stream()).toList();
  }

  private Corridor updatePassage(ReferenceTrajectory trajectory, List<Vec2> seen) {
    Corridor corridor = new Corridor(trajectory.posesAhead(RangeSensors.FARTHEST + 2 * radius));
    passage = Passage.through(corridor, seen, radius, mostAside);
    remember();
    return corridor;
  }

  private void remember() {
    blockingSightings.remember(newSightings.stream().filter(passage::isRelevant).toList(), now);
    nearSightings.remember(newSightings.stream().filter(this::isNear).toList(), now);
  }

  private boolean isNear(Vec2 point) {
    return passage.blocking().stream().anyMatch(p -> p.distanceTo(point) < SAME_OBSTACLE_METRES);
  }

  private boolean isStopped() {
    return passage.freeDistance() < STOP_DISTANCE;
  }

  /**
   * Where the robot shall be.
   *
   * @param reference where it would be on its path, map frame
   */
  Pose corrected(Pose reference) {
    return glance.turned(sidestep.beside(reference));
  }

  /**
   * How the robot shall move, in its own frame.
   *
   * @param reference how it would move on its path, in its own frame
   */
  Twist corrected(Twist reference) {
    return glance.turned(sidestep.beside(reference));
  }

  /** The points of the obstacles that block the path, map frame. */
  public List<Vec2> obstacles() {
    return passage.blocking().isEmpty() ? List.of() : nearSightings.points();
  }

  /** What it is stopped by; empty where nothing stops it. */
  public Optional<Fault> fault() {
    return isStopped()
        ? Optional.of(
            new Fault(
                "OBSTACLE",
                String.format(
                    Locale.ROOT,
                    "There is an obstacle %.2f m ahead; the robot waits until it is gone.",
                    passage.ahead())))
        : Optional.empty();
  }
}
