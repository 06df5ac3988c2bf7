package org.toqa.agent.drive;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.avoidance.Bypass;
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
import org.toqa.link.message.AgentMessage.RoomUse;
import org.toqa.motion.DriveKind;
import org.toqa.motion.PassingRoom;

/**
 * Watches the path that a robot is about to drive: lets it pass beside an obstacle that only
 * reaches in, or in room that it was lent round one that is on the path; else stops it before that,
 * and turns it a little to see how wide that is. A leader only stops.
 */
public final class ObstacleAvoider {

  private static final Passage FREE_PASSAGE =
      new Passage(List.of(), List.of(), Double.POSITIVE_INFINITY);

  /** Metres round a point that blocks the path: what is seen there belongs to the same obstacle. */
  private static final double SAME_OBSTACLE_METRES = 0.5;

  /** Metres of the path on which it looks where it drives, while it passes something. */
  private static final double PASSING_METRES = 1.6;

  /** Metres; so exactly it remembers where things are that it drives round. */
  private static final double SHARP = 0.01;

  /** Share of its speed; who may not go as slowly stands. */
  private static final double SLOWEST = 0.05;

  /** Metres; with less room than this it stays stopped. */
  private static final double STOP_DISTANCE = 0.02;

  private final double radius;
  private final double mostAside;

  /** Whether it sees what it drives round until that is behind it. */
  private final boolean canPass;

  private final RangeSensors sensors;
  private final DetectionMemory blockingSightings = new DetectionMemory();
  private final DetectionMemory nearSightings = new DetectionMemory();
  private final DetectionMemory sightings = new DetectionMemory(SHARP);
  private final Sidestep sidestep = new Sidestep();
  private final Bypass bypass;

  /** Of a robot that cannot look round while it passes something; null: it can. */
  private final @Nullable ContactGuard guard;

  private final ScanTurn glance = new ScanTurn();
  private List<Vec2> newSightings = List.of();
  private double now;
  private Passage passage = FREE_PASSAGE;
  private List<Vec2> lineAhead = List.of();
  private boolean mayPass;

  /** What the traffic has lent it beside its path; null: nothing. */
  private @Nullable PassingRoom room;

  /**
   * @param radius of the robot, metres
   * @param kind of the robot: one that cannot go sideways stops before what is beside its path, too
   *     near to it
   */
  public ObstacleAvoider(double radius, DriveKind kind) {
    this(radius, kind, new RangeSensors(radius), 1);
  }

  /**
   * The same with other sensors.
   *
   * @param braking metres a second squared
   */
  public ObstacleAvoider(double radius, DriveKind kind, RangeSensors sensors, double braking) {
    this.radius = radius;
    this.mostAside = kind.canGoSideways() ? Sidestep.MAX_OFFSET : 0;
    this.canPass = kind.canGoSideways() || sensors.lookToBothSides();
    this.sensors = sensors;
    this.bypass = new Bypass(radius, kind.canGoSideways());
    this.guard = kind.canGoSideways() ? null : new ContactGuard(sensors, radius, braking);
  }

  /**
   * To be called first in every tick.
   *
   * @param ranges metres, in the order of the range sensors
   * @param pose where the robot is, map frame
   * @param seconds on a monotonic clock
   */
  public void observe(List<Double> ranges, Pose pose, double seconds) {
    if (guard != null) {
      guard.look(pose, ranges, List.of(), seconds - now);
    }
    now = seconds;
    blockingSightings.forgetOld(now);
    nearSightings.forgetOld(now);
    sightings.forgetOld(now);
    newSightings = sensors.detections(ranges, pose);
    sightings.forget(point -> sensors.areThrough(ranges, pose, point));
    sightings.remember(newSightings, now);
    passage = FREE_PASSAGE;
    lineAhead = List.of();
  }

  /** From now on the robot may be beside its path there, until it is past what is in its way. */
  public void lend(PassingRoom lent) {
    room = lent;
  }

  /** What it was lent and has not given back. */
  public Optional<PassingRoom> room() {
    return Optional.ofNullable(room);
  }

  /** Whether it has room beside its path, or needs it to get on. */
  public RoomUse roomUse() {
    if (room != null) {
      return RoomUse.HELD;
    }
    return mayPass && !passage.blocking().isEmpty() ? RoomUse.WANTED : RoomUse.NONE;
  }

  /**
   * Looks along the trajectory, and slows it down before obstacles.
   *
   * @param seconds since the last call
   * @param onward whether the robot may move
   */
  public void avoidObstacles(ReferenceTrajectory trajectory, double seconds, boolean onward) {
    mayPass = canPass;
    if (room != null) {
      passInRoom(room, trajectory, seconds, onward);
      return;
    }
    List<Vec2> seen = sightedPoints();
    if (!seen.isEmpty() || !sidestep.isOnPath() || !glance.isStraight()) {
      Corridor corridor = updatePassage(trajectory, seen);
      sidestep.step(
          trajectory.pose(), trajectory.twist().vx(), passage.beside(), corridor.length(), seconds);
      glance(trajectory, seconds, onward);
    }
    trajectory.stopWithin(glance.isStraight() ? passage.freeDistance() : 0);
  }

  /** Drives round what is on the path, and gives the room back behind it. */
  private void passInRoom(
      PassingRoom lent, ReferenceTrajectory trajectory, double seconds, boolean onward) {
    Corridor corridor = new Corridor(trajectory.posesAhead(PASSING_METRES));
    Bypass.Room there =
        new Bypass.Room(
            trajectory.metresTo(lent.from()),
            trajectory.metresTo(lent.to()),
            lent.left(),
            lent.right());
    Bypass.Way way =
        bypass.step(corridor, there, trajectory.twist(), sightings.points(), seconds, onward);
    lineAhead = way.line();
    passage = new Passage(way.blocking(), List.of(), way.free() + Passage.STOP_GAP);
    remember();
    sidestep.step(
        trajectory.pose(), trajectory.twist().vx(), List.of(), corridor.length(), seconds);
    glance(trajectory, seconds, onward);
    trajectory.stopWithin(glance.isStraight() ? passage.freeDistance() : 0);
    boolean isPast =
        way.blocking().stream().noneMatch(p -> corridor.beside(p).along() < there.end());
    if (bypass.isOnPath() && isPast) {
      room = null; // for what comes behind it, it asks anew
    }
  }

  private void glance(ReferenceTrajectory trajectory, double seconds, boolean onward) {
    if (onward) {
      glance.step(isStopped() && trajectory.isStanding(), seconds);
    } else {
      glance.hold();
    }
  }

  /** How fast the robot's place on its path may move, as a share of the planned speed. */
  public double pace(ReferenceTrajectory trajectory) {
    return room == null ? 1 : bypass.pace(trajectory.plannedTwist());
  }

  /**
   * As fast as a robot may go in its room that cannot look round there: what it saw may move, and
   * it stops before that.
   *
   * @param robot where it is, map frame
   * @param wanted how it would move, in its own frame
   */
  public Twist guarded(Pose robot, Twist wanted) {
    if (room == null || guard == null) {
      return wanted;
    }
    for (double share = 1; share >= SLOWEST; share /= 2) {
      Twist tried = wanted.times(share);
      if (guard.isSafe(robot, tried)) {
        return tried;
      }
    }
    return Twist.ZERO;
  }

  /** Where the robot's middle will be on the next metres, map frame. */
  List<Vec2> lineAhead(ReferenceTrajectory trajectory, double metres) {
    return lineAhead.isEmpty()
        ? trajectory.posesAhead(metres).stream().map(Pose::position).toList()
        : lineAhead;
  }

  /** The same for a leader, which has a load beside it: it neither steps aside nor turns. */
  public void stopForObstacles(ReferenceTrajectory trajectory) {
    mayPass = false;
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
        || !bypass.isOnPath()
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
    return glance.turned(bypass.beside(sidestep.beside(reference)));
  }

  /**
   * How the robot shall move, in its own frame.
   *
   * @param reference how it would move on its path, in its own frame
   */
  Twist corrected(Twist reference) {
    return glance.turned(bypass.beside(sidestep.beside(reference)));
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
