package org.toqa.agent.chassis;

import java.util.List;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.DriveKind;

/**
 * The segments of one path that a simulated body drives by itself, as the firmware does: the
 * reference runs along what is in the queue, and the body is steered after it by its own odometry.
 */
final class SegmentQueue {

  private final long path;
  private final SegmentRunner runner;
  private boolean onward = true;

  /**
   * Begins a path.
   *
   * @param kind of the body
   */
  SegmentQueue(DrivePath order, DriveKind kind) {
    path = order.number();
    runner =
        new SegmentRunner(
            new ReferenceTrajectory(order.start(), List.of(), 0, order.limits()), kind);
    take(order);
    runner.trajectory().setProgress(0, 0, order.pace());
  }

  /** The number of its path. */
  long path() {
    return path;
  }

  /** Takes what is new of its path. */
  void take(DrivePath order) {
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
  Twist steer(Pose odometry, double seconds) {
    return runner.steer(odometry, seconds, onward ? 1 : 0);
  }

  PathProgress progress() {
    ReferenceTrajectory trajectory = runner.trajectory();
    return new PathProgress(
        path,
        trajectory.completedCount(),
        trajectory.secondsInSegment(),
        trajectory.pace(),
        runner.isSettled());
  }
}
