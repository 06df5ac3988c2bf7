package org.toqa.agent.drive;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.toqa.formation.FollowerLaw;
import org.toqa.formation.Gains;
import org.toqa.formation.SingleIntegratorLaw;
import org.toqa.formation.UnicycleLaw;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Trajectory;

/**
 * Drives a robot along a {@link ReferenceTrajectory}: the reference runs ahead, the robot is
 * steered after it, and where it is stopped the robot is corrected towards it until it is within
 * {@link #SETTLED_METRES}. The reference slows down for a robot that falls behind or comes aside,
 * and waits for it, so that a blocked robot is not left alone by it.
 *
 * <p>A robot that cannot go sideways comes back to its path while it drives, and stands where it is
 * beside it: only what it lags behind slows the reference down, and has to be settled.
 *
 * <p>A robot that is more than {@link Trajectory#MAX_DEVIATION} beside its path stands, for nobody
 * has kept that place free; it goes on when it is put back, or by another drive from where it is.
 */
public final class SegmentRunner {

  static final double SETTLED_METRES = 0.001;
  static final double SETTLED_RADIANS = 0.002;

  /** Settled stays settled within this many times the tolerance. */
  private static final double HYSTERESIS = 3;

  /** From this error on the reference slows down; at the second it waits. */
  private static final double SLOWING_METRES = 0.02;

  private static final double WAITING_METRES = Trajectory.MAX_DEVIATION;

  /** A robot that stands beside its path goes on when it is as near to that again. */
  private static final double RETURNED_METRES = Trajectory.MAX_DEVIATION / 2;

  /** Of the path before and behind the reference, where the robot is looked for. */
  private static final double PATH_METRES = 0.3;

  /** Between two points of the path behind the reference. */
  private static final double TRAIL_SPACING = 0.01;

  /**
   * Ticks after which a body is as fast as commanded: one until the next exchange, two of motor
   * lag. The robot is compared with where the reference was then; else it would be pushed while it
   * speeds up and run on when it slows down.
   */
  private static final int RESPONSE_TICKS = 3;

  /** Time constant 1/3 s, well above the 20 ms of a tick and the lag of the motors. */
  private static final FollowerLaw OMNI = new SingleIntegratorLaw(new Gains(3, 3, 0.1, 0.5));

  private static final FollowerLaw DIFFERENTIAL = new UnicycleLaw();

  private final ReferenceTrajectory trajectory;
  private final ObstacleAvoider avoider;
  private final DriveKind kind;
  private final Deque<Pose> pastReferences = new ArrayDeque<>();

  /** The path that the reference has left behind, as points, the newest last. */
  private final Deque<Vec2> trail = new ArrayDeque<>();

  private boolean settled;
  private double deviation;
  private boolean isOffPath;

  public SegmentRunner(ReferenceTrajectory trajectory, DriveKind kind) {
    this(trajectory, kind, new ObstacleAvoider(0, kind));
  }

  /**
   * @param kind of the robot
   * @param avoider says how far beside its path the robot drives
   */
  public SegmentRunner(ReferenceTrajectory trajectory, DriveKind kind, ObstacleAvoider avoider) {
    this.trajectory = trajectory;
    this.kind = kind;
    this.avoider = avoider;
    pastReferences.add(trajectory.pose());
    trail.add(trajectory.pose().position());
  }

  public ReferenceTrajectory trajectory() {
    return trajectory;
  }

  /** Metres between the robot and its path; never negative. */
  public double deviation() {
    return deviation;
  }

  /** Whether the robot stands because it is too far beside its path. */
  public boolean isOffPath() {
    return isOffPath;
  }

  /** Whether the reference is stopped, and the robot at its place. */
  public boolean isSettled() {
    return settled;
  }

  /** Whether the robot is stopped at the end of the last segment. */
  public boolean isAtEnd() {
    return settled && trajectory.completedCount() == trajectory.size();
  }

  /**
   * Moves the reference on, and follows it.
   *
   * @param actual where the robot is, map frame
   * @param seconds since the last call
   * @param pace at which the reference may run, as a share of the planned speed; at 0 it slows down
   *     and is stopped
   * @return the velocity to command, in the robot's frame
   */
  public Twist steer(Pose actual, double seconds, double pace) {
    double error = observe(actual);
    double slack = (WAITING_METRES - error) / (WAITING_METRES - SLOWING_METRES);
    trajectory.advance(seconds, isOffPath ? 0 : Math.min(pace, Math.clamp(slack, 0, 1)));
    Pose reference = avoider.corrected(trajectory.pose());
    leaveTrail(reference.position());
    Pose followed = delayedReference(reference);
    settled = trajectory.isStanding() && isNear(reference, actual, settled ? HYSTERESIS : 1);
    return settled || isOffPath
        ? Twist.ZERO
        : law().velocity(followed, avoider.corrected(trajectory.twist()), actual);
  }

  /**
   * Watches a body that follows the reference by itself.
   *
   * @param actual where the robot is, map frame
   */
  public void watch(Pose actual) {
    observe(actual);
    leaveTrail(trajectory.pose().position());
    delayedReference(trajectory.pose());
    settled = false;
  }

  /** The robot has come to where the reference is by another way. */
  public void restart() {
    pastReferences.clear();
    pastReferences.add(trajectory.pose());
    trail.clear();
    trail.add(trajectory.pose().position());
    settled = false;
    isOffPath = false;
  }

  private FollowerLaw law() {
    return switch (kind) {
      case OMNI -> OMNI;
      case DIFFERENTIAL -> DIFFERENTIAL;
    };
  }

  /**
   * Returns how far the robot is from where the reference was, in metres; one that cannot go
   * sideways, in the direction in which it can.
   */
  private double observe(Pose actual) {
    Pose reference = pastReferences.getFirst();
    double error = reference.distanceTo(actual);
    deviation = error <= RETURNED_METRES ? error : distanceToPath(actual.position());
    isOffPath = deviation > (isOffPath ? RETURNED_METRES : Trajectory.MAX_DEVIATION);
    return kind.canGoSideways() ? error : lag(reference, actual);
  }

  /** Metres that a robot is before or behind where it should be. */
  private static double lag(Pose reference, Pose actual) {
    return Math.abs(reference.position().minus(actual.position()).rotated(-actual.theta()).x());
  }

  private void leaveTrail(Vec2 point) {
    if (point.distanceTo(trail.getLast()) >= TRAIL_SPACING) {
      trail.addLast(point);
      if (trail.size() > PATH_METRES / TRAIL_SPACING) {
        trail.removeFirst();
      }
    }
  }

  private double distanceToPath(Vec2 point) {
    List<Vec2> path = new ArrayList<>(trail);
    path.addAll(avoider.lineAhead(trajectory, PATH_METRES));
    double nearest = point.distanceTo(path.getFirst());
    for (int i = 1; i < path.size(); i++) {
      nearest = Math.min(nearest, point.distanceToLine(path.get(i - 1), path.get(i)));
    }
    return nearest;
  }

  private Pose delayedReference(Pose reference) {
    pastReferences.addLast(reference);
    return pastReferences.size() > RESPONSE_TICKS
        ? pastReferences.removeFirst()
        : pastReferences.getFirst();
  }

  private boolean isNear(Pose reference, Pose actual, double tolerances) {
    double error = kind.canGoSideways() ? reference.distanceTo(actual) : lag(reference, actual);
    return error <= SETTLED_METRES * tolerances
        && Math.abs(Angles.difference(reference.theta(), actual.theta()))
            <= SETTLED_RADIANS * tolerances;
  }
}
