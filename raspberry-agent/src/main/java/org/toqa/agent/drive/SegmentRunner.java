package org.toqa.agent.drive;

import java.util.ArrayDeque;
import java.util.Deque;
import org.toqa.formation.FollowerLaw;
import org.toqa.formation.Gains;
import org.toqa.formation.SingleIntegratorLaw;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * Drives a robot along a {@link ReferenceTrajectory}: the reference runs ahead, the robot is
 * steered after it, and where it is stopped the robot is corrected towards it until it is within
 * {@link #SETTLED_METRES}. The reference waits for a robot that falls behind, so that a blocked
 * robot is not left alone by it.
 */
public final class SegmentRunner {

  static final double SETTLED_METRES = 0.001;
  static final double SETTLED_RADIANS = 0.002;

  /** Settled stays settled within this many times the tolerance. */
  private static final double HYSTERESIS = 3;

  /** From this error on the reference slows down; at the second it waits. */
  private static final double SLOWING_METRES = 0.05;

  private static final double WAITING_METRES = 0.15;

  /**
   * Ticks after which a body is as fast as commanded: one until the next exchange, two of motor
   * lag. The robot is compared with where the reference was then; else it would be pushed while it
   * speeds up and run on when it slows down.
   */
  private static final int RESPONSE_TICKS = 3;

  /** Time constant 1/3 s, well above the 20 ms of a tick and the lag of the motors. */
  private static final FollowerLaw TRACKING = new SingleIntegratorLaw(new Gains(3, 3, 0.1, 0.5));

  private final ReferenceTrajectory trajectory;
  private final ObstacleAvoider avoider;
  private final Deque<Pose> pastReferences = new ArrayDeque<>();
  private boolean settled;
  private double trackingError;

  public SegmentRunner(ReferenceTrajectory trajectory) {
    this(trajectory, new ObstacleAvoider(0));
  }

  /**
   * @param avoider says how far beside its path the robot drives
   */
  public SegmentRunner(ReferenceTrajectory trajectory, ObstacleAvoider avoider) {
    this.trajectory = trajectory;
    this.avoider = avoider;
    pastReferences.add(trajectory.pose());
  }

  public ReferenceTrajectory trajectory() {
    return trajectory;
  }

  /** Metres between the robot and where it should be by now; never negative. */
  public double trackingError() {
    return trackingError;
  }

  /** Whether the robot is so far from the reference that the reference waits for it. */
  public boolean isOffTrajectory() {
    return trackingError > WAITING_METRES;
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
    trackingError = pastReferences.getFirst().distanceTo(actual);
    double slack = (WAITING_METRES - trackingError) / (WAITING_METRES - SLOWING_METRES);
    trajectory.advance(seconds, Math.min(pace, Math.clamp(slack, 0, 1)));
    Pose reference = avoider.corrected(trajectory.pose());
    settled = trajectory.isStanding() && isNear(reference, actual, settled ? HYSTERESIS : 1);
    return settled
        ? Twist.ZERO
        : TRACKING.velocity(
            delayedReference(reference), avoider.corrected(trajectory.twist()), actual);
  }

  private Pose delayedReference(Pose reference) {
    pastReferences.addLast(reference);
    return pastReferences.size() > RESPONSE_TICKS
        ? pastReferences.removeFirst()
        : pastReferences.getFirst();
  }

  private static boolean isNear(Pose reference, Pose actual, double tolerances) {
    return reference.distanceTo(actual) <= SETTLED_METRES * tolerances
        && Math.abs(Angles.difference(reference.theta(), actual.theta()))
            <= SETTLED_RADIANS * tolerances;
  }
}
