package org.toqa.agent.chassis;

import java.util.List;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.Segment;

/** What a body is told to do; each command takes the place of the one before. */
public sealed interface ChassisCommand {

  /** The same, no faster than that; the segments of a path were checked before. */
  default ChassisCommand within(MotionLimits limits) {
    return this;
  }

  /**
   * Move like this, until the next command.
   *
   * @param velocity in the robot's frame
   */
  record MoveAt(Twist velocity) implements ChassisCommand {
    /** Stand still. */
    public static final MoveAt STANDSTILL = new MoveAt(Twist.ZERO);

    @Override
    public ChassisCommand within(MotionLimits limits) {
      return new MoveAt(limits.clampedTwist(velocity));
    }
  }

  /**
   * Drive along segments, one after the other, by the body's own odometry, to a standstill at the
   * end of the last one that it has. The same path is commanded at every tick, with what has become
   * new: the body takes from it what it does not have yet, as far as its queue of {@link
   * Chassis#QUEUE_LENGTH} has room.
   *
   * @param number of the path, from 1; a later path has a higher one. A path that the body has
   *     dropped, since another command or a stop came between, is not driven once more
   * @param start where the first segment begins, in the frame of the body's odometry
   * @param pace with which a new path begins, as a share of the planned speed, 0 to 1
   * @param limits how abruptly the pace may change
   * @param first which of the path's segments is the first one of those here, from 0
   * @param segments from that one on, those that may be driven, or the next ones of them
   * @param onward false: slow down on the path, and stand there
   */
  record DrivePath(
      long number,
      Pose start,
      double pace,
      PaceLimits limits,
      int first,
      List<Segment> segments,
      boolean onward)
      implements ChassisCommand {

    public DrivePath {
      segments = List.copyOf(segments);
    }

    /**
     * Those of the segments that a body does not have yet.
     *
     * @param known how many of the path's segments it has
     */
    public List<Segment> segmentsFrom(int known) {
      int skipped = Math.clamp(known - (long) first, 0, segments.size());
      return segments.subList(skipped, segments.size());
    }
  }
}
