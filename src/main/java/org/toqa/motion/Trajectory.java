package org.toqa.motion;

import java.util.List;
import org.toqa.geometry.Pose;

/**
 * Segments driven one after the other from a start pose.
 *
 * @param start map frame, as all poses on it
 */
public record Trajectory(Pose start, List<Segment> segments) {
  /**
   * Metres that a robot may be beside the trajectory that it drives. It is a part of the robot
   * link's contract: a robot that is farther from it stands and says so.
   */
  public static final double MAX_DEVIATION = 0.05;

  public Trajectory {
    segments = List.copyOf(segments);
  }

  /** Seconds in all. */
  public double duration() {
    return segments.stream().mapToDouble(Segment::t).sum();
  }

  /** Metres in all. */
  public double length() {
    return segments.stream().mapToDouble(Segment::length).sum();
  }

  /**
   * The pose when the first {@code count} segments are completed.
   *
   * @param count 0 to the number of segments
   * @return map frame
   * @throws IndexOutOfBoundsException if there are fewer
   */
  public Pose poseAfter(int count) {
    Pose pose = start;
    for (Segment s : segments.subList(0, count)) {
      pose = pose.advanced(s.twist(), s.t());
    }
    return pose;
  }

  /** The pose when all segments are completed. */
  public Pose end() {
    return poseAfter(segments.size());
  }

  /**
   * The pose at a moment, map frame; the end pose from the end on.
   *
   * @param seconds after the start; below 0 counts as 0
   */
  public Pose poseAt(double seconds) {
    Pose pose = start;
    double left = seconds;
    for (Segment s : segments) {
      if (left <= s.t()) {
        return pose.advanced(s.twist(), Math.max(0, left));
      }
      pose = pose.advanced(s.twist(), s.t());
      left -= s.t();
    }
    return pose;
  }
}
