package org.toqa.agent.chassis;

import java.util.List;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.DriveKind;

/**
 * The segments of one path that a body drives by itself whose wheels can only be told their speeds,
 * as the firmware does: the reference runs along what is in the queue, and the body is steered
 * after it by its own odometry.
 */
public final class SegmentQueue {

  private final long path;
  private final SegmentRunner runner;
  private boolean onward = true;

  /**
   * Begins a path.
   *
   * @param kind of the body
   */
  public SegmentQueue(DrivePath order, DriveKind kind) {
    path = order.number();
    runner =
        new SegmentRunner(
            new ReferenceTrajectory(order.start(), List.of(), 0, order.limits()), kind);
    take(order);
    runner.trajectory().setProgress(0, 0, order.pace());
  }

  /** The number of its path. */
  public long path() {
    return path;
  }

  /** Takes what is new of its path. */
  public void take(DrivePath order) {
    onward = order.onward();
    ReferenceTrajectory trajectory = runner.trajectory();
    int known = trajectory.size();
    int room = Chassis.QUEUE_LENGTH - (known - trajectory.completedCount());
    if (order.first() <= known) {
      var segments = order.segmentsFrom(known);
      var taken = segments.subList(0, Math.min(room, segments.size()));
      if (!taken.isEmpty()) {
        trajectory.replace(known, taken, known + taken.size());
      }
    }
  }

  /**
   * Drives on.
   *
   * @param odometry where the body takes itself to be
   * @return the velocity to turn the wheels for, robot frame
   */
  public Twist steer(Pose odometry, double seconds) {
    return runner.steer(odometry, seconds, onward ? 1 : 0);
  }

  /** How far it has come. */
  public PathProgress progress() {
    ReferenceTrajectory trajectory = runner.trajectory();
    return new PathProgress(
        path,
        trajectory.completedCount(),
        trajectory.secondsInSegment(),
        trajectory.pace(),
        runner.isSettled());
  }
}
