package org.toqa.agent.control;

import java.util.Locale;
import java.util.Optional;
import org.toqa.agent.config.MotionLimits;
import org.toqa.agent.control.Activity.Tick;
import org.toqa.agent.drive.ObstacleAvoider;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;

/**
 * The current drive: its trajectory, whether it ends its phase, and whether it was cancelled. A
 * cancelled drive comes to a standstill on its path and is then dropped.
 */
final class DriveRun {

  private final SegmentRunner runner;
  private final ObstacleAvoider avoider;
  private boolean isFinal;
  private boolean isCancelled;

  /**
   * @param avoider has seen nothing yet
   */
  DriveRun(Drive order, MotionLimits limits, ObstacleAvoider avoider) {
    this.avoider = avoider;
    runner =
        new SegmentRunner(
            new ReferenceTrajectory(
                order.start(),
                order.segments(),
                order.released(),
                PaceLimits.forSingleRobot(limits)),
            avoider);
    isFinal = order.last();
  }

  ReferenceTrajectory trajectory() {
    return runner.trajectory();
  }

  void extend(Extend order) {
    trajectory().replace(order.from(), order.segments(), order.released());
    isFinal = order.last();
  }

  void cancel() {
    isCancelled = true;
  }

  boolean isCancelled() {
    return isCancelled;
  }

  /**
   * Drives on by one tick, beside or up to obstacles.
   *
   * @return the velocity to command, in the robot's frame
   */
  Twist steer(Tick tick) {
    avoider.avoidObstacles(trajectory(), tick.seconds(), canMove(tick));
    return runner.steer(tick.pose(), tick.seconds(), canMove(tick) ? 1 : 0);
  }

  /**
   * The same, but only up to obstacles.
   *
   * @param limits that hold from now on
   * @param pace as a share of the planned speed, 0 to 1
   */
  Twist steerAsLeader(Tick tick, PaceLimits limits, double pace) {
    avoider.stopForObstacles(trajectory());
    trajectory().setLimits(limits);
    return runner.steer(tick.pose(), tick.seconds(), canMove(tick) ? pace : 0);
  }

  private boolean canMove(Tick tick) {
    return tick.canMove() && !isCancelled;
  }

  /** Whether the robot is at the end of the last drive of its phase. */
  boolean isAtEndOfPhase() {
    return isFinal && runner.isAtEnd();
  }

  /** Whether the reference is stopped. */
  boolean isStanding() {
    return trajectory().isStanding();
  }

  /** Whether the reference is stopped at the end of what is released. */
  boolean isWaitingForRelease() {
    return trajectory().completedCount() == trajectory().releasedCount() && isStanding();
  }

  /** How many segments the reference has completed; 0 when cancelled. */
  int reportedSegment() {
    return isCancelled ? 0 : trajectory().completedCount();
  }

  /** How many segments may be driven; 0 when cancelled. */
  int reportedRelease() {
    return isCancelled ? 0 : trajectory().releasedCount();
  }

  /** That the robot stands because it is too far beside its path; empty while it does not. */
  Optional<Fault> fault() {
    return runner.isOffPath()
        ? Optional.of(
            new Fault(
                "OFF_WAY",
                String.format(
                    Locale.ROOT,
                    "The robot is %.2f m off its path; it stands.",
                    runner.deviation())))
        : Optional.empty();
  }
}
