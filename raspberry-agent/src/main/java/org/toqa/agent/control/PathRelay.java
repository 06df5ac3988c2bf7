package org.toqa.agent.control;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.PathProgress;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

/**
 * Hands the released segments of a drive to the body, which drives them by its own odometry, and
 * moves the drive's trajectory to where the body's reference is. Nothing that is not released is
 * handed on, so the body stands at the end of what is released whatever becomes of the daemon.
 *
 * <p>The body's odometry and the map are tied together when a path begins. Where the robot learns
 * meanwhile that it is elsewhere, the rest of the segments goes to the body anew, as another path
 * that begins at the same place of the map. The same is done after the daemon has steered by
 * itself.
 */
final class PathRelay {

  private static final Pose ORIGIN = new Pose(0, 0, 0);

  /** The robot learned that it is elsewhere when its place changed by more than this. */
  private static final double MOVED_METRES = 0.001;

  private static final double MOVED_RADIANS = 0.001;

  private final ReferenceTrajectory trajectory;
  private final PaceLimits limits;
  private final LongSupplier pathNumbers;
  private @Nullable Relayed relayed;

  /**
   * What the body was given.
   *
   * @param path without segments
   * @param base how many of the drive's segments lie before the path
   * @param offset seconds of the path's first segment that lie before the path
   * @param anchor the map's pose of the origin of the body's odometry
   * @param accepted whether the body has begun it
   */
  private record Relayed(
      DrivePath path, int base, double offset, Pose anchor, boolean accepted, boolean settled) {

    Relayed accepted(boolean isSettled) {
      return new Relayed(path, base, offset, anchor, true, isSettled);
    }
  }

  /**
   * @param trajectory of the drive
   * @param limits how abruptly a robot alone changes its pace
   * @param pathNumbers a higher one at each call, from 1
   */
  PathRelay(ReferenceTrajectory trajectory, PaceLimits limits, LongSupplier pathNumbers) {
    this.trajectory = trajectory;
    this.limits = limits;
    this.pathNumbers = pathNumbers;
  }

  /** Whether the body drives by itself, or was told to. */
  boolean isActive() {
    return relayed != null;
  }

  /** Whether the body has begun with it. */
  boolean isAccepted() {
    return relayed != null && relayed.accepted();
  }

  /** Whether the body has come to rest, with the reference standing. */
  boolean isSettled() {
    return relayed != null && relayed.settled();
  }

  /** Takes how far the body has come; to be called first in every tick. */
  void update(ChassisReading reading, Pose pose) {
    Relayed now = relayed;
    if (now == null) {
      return;
    }
    PathProgress progress = reading.progress();
    if (progress != null && progress.path() == now.path().number()) {
      double before = progress.completed() == 0 ? now.offset() : 0;
      trajectory.setProgress(
          now.base() + progress.completed(), before + progress.seconds(), progress.pace());
      relayed = now.accepted(progress.settled());
      if (hasMoved(now.anchor(), reading, pose)) {
        begin(reading, pose);
      }
    } else if (now.accepted()) {
      stop();
      trajectory.setProgress(
          trajectory.completedCount(), trajectory.secondsInSegment(), 0); // the body has stopped
    }
  }

  private static boolean hasMoved(Pose anchor, ChassisReading reading, Pose pose) {
    Pose expected = anchor.compose(reading.odometry());
    return expected.distanceTo(pose) > MOVED_METRES
        || Math.abs(Angles.difference(expected.theta(), pose.theta())) > MOVED_RADIANS;
  }

  /** The daemon steers by itself. */
  void stop() {
    relayed = null;
  }

  /** Gives the body what is left of the trajectory, from where its reference is. */
  void begin(ChassisReading reading, Pose pose) {
    Pose start = reading.odometry().compose(pose.relative(trajectory.pose()));
    Pose anchor = pose.compose(reading.odometry().relative(ORIGIN));
    relayed =
        new Relayed(
            new DrivePath(
                pathNumbers.getAsLong(), start, trajectory.pace(), limits, 0, List.of(), true),
            trajectory.completedCount(),
            trajectory.secondsInSegment(),
            anchor,
            false,
            false);
  }

  /**
   * What to command the body; while it is active.
   *
   * @param onward false: it shall slow down on its path, and stand
   */
  DrivePath command(boolean onward) {
    Relayed now = relayed;
    if (now == null) {
      throw new IllegalStateException("The body was given no path.");
    }
    DrivePath path = now.path();
    int from = trajectory.completedCount();
    return new DrivePath(
        path.number(),
        path.start(),
        path.pace(),
        limits,
        from - now.base(),
        segments(now, from),
        onward);
  }

  private List<Segment> segments(Relayed now, int from) {
    int to = Math.min(trajectory.releasedCount(), from + Chassis.QUEUE_LENGTH);
    List<Segment> segments = new ArrayList<>();
    for (int i = from; i < to; i++) {
      Segment whole = trajectory.segment(i);
      segments.add(i == now.base() ? whole.lasting(whole.t() - now.offset()) : whole);
    }
    return segments;
  }
}
