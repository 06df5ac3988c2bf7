package org.toqa.agent.drive;

import com.google.errorprone.annotations.FormatMethod;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.FreeZone;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * What a robot refuses to drive, whoever asks for it. Each rule answers with the sentence that goes
 * back to the server, or with nothing.
 */
public final class DriveRules {

  /** Metres that a robot may be from its drive's start. */
  private static final double START_METRES = Trajectory.MAX_DEVIATION;

  private static final double START_RADIANS = Math.toRadians(10);

  private static final int MOST_SEGMENTS = 100_000;
  private static final double LONGEST_SEGMENT_SECONDS = 3_600;

  private static final double WIDEST_ROOM = 1;

  /** No floor is larger than this. */
  private static final double LARGEST_COORDINATE = 100_000;

  /** A speed that is the limit but for its last digits is no fault. */
  private static final double ROUNDING = 1 + 1e-9;

  private final MotionLimits limits;
  private final double radius;

  /**
   * @param radius of the robot, metres
   */
  public DriveRules(MotionLimits limits, double radius) {
    this.limits = limits;
    this.radius = radius;
  }

  public Optional<String> objectionTo(Drive drive, Pose robotPose) {
    if (drive.phase() < 0 || drive.phase() > 3) {
      return objection("The phase %d is not one of 0 to 3.", drive.phase());
    }
    if ((drive.task() == null) != (drive.phase() == 0)) {
      return objection(
          "A drive without a task has phase 0, and one for a task has phase 1, 2 or 3.");
    }
    if (drive.released() < 0 || drive.released() > drive.segments().size()) {
      return objection(
          "Of %d segments %d cannot be released.", drive.segments().size(), drive.released());
    }
    double away = drive.start().distanceTo(robotPose);
    double turned = Math.abs(Angles.difference(drive.start().theta(), robotPose.theta()));
    if (!(away <= START_METRES) || !(turned <= START_RADIANS)) {
      return objection(
          "The drive starts %.2f m and %.0f degrees away from where the robot is,"
              + " (%.2f, %.2f) facing %.0f degrees.",
          away,
          Math.toDegrees(turned),
          robotPose.x(),
          robotPose.y(),
          Math.toDegrees(robotPose.theta()));
    }
    return objectionTo(drive.segments(), 0);
  }

  public Optional<String> objectionTo(Extend extend, ReferenceTrajectory trajectory) {
    if (extend.from() < trajectory.releasedCount() || extend.from() > trajectory.size()) {
      return objection(
          "Segments can be replaced from %d (what is released stays) to %d, not from %d.",
          trajectory.releasedCount(), trajectory.size(), extend.from());
    }
    int size = extend.from() + extend.segments().size();
    if (extend.released() < trajectory.releasedCount() || extend.released() > size) {
      return objection(
          "What is released only grows: from %d to at most %d, not %d.",
          trajectory.releasedCount(), size, extend.released());
    }
    return objectionTo(extend.segments(), extend.from());
  }

  public Optional<String> objectionTo(Release release, ReferenceTrajectory trajectory) {
    if (release.released() < trajectory.releasedCount() || release.released() > trajectory.size()) {
      return objection(
          "What is released only grows: from %d to at most %d, not %d.",
          trajectory.releasedCount(), trajectory.size(), release.released());
    }
    return Optional.empty();
  }

  public Optional<String> objectionTo(Room room, ReferenceTrajectory trajectory) {
    if (!(0 <= room.from() && room.from() < room.to() && room.to() <= trajectory.releasedCount())) {
      return objection(
          "Room can be lent beside segments that are released, 0 to %d, not %d to %d.",
          trajectory.releasedCount(), room.from(), room.to());
    }
    FreeZone zone = room.zone();
    if (zone != null) {
      return objectionTo(room, zone, trajectory);
    }
    if (!isWidth(room.left()) || !isWidth(room.right())) {
      return objection(
          "Room beside a path is 0 to %.1f m wide, not %s and %s m.",
          WIDEST_ROOM, room.left(), room.right());
    }
    for (int i = room.from(); i < room.to(); i++) {
      if (trajectory.segment(i).v() <= 0) {
        return objection("On segment %d the robot does not drive forward; no room helps there.", i);
      }
    }
    return Optional.empty();
  }

  private Optional<String> objectionTo(Room room, FreeZone zone, ReferenceTrajectory trajectory) {
    if (room.to() <= trajectory.completedCount()) {
      return objection("The robot has left segment %d behind already.", room.to() - 1);
    }
    if (!(zone.speed() > 0)) {
      return objection("In a free zone a robot drives faster than 0 m/s, not %s.", zone.speed());
    }
    for (int i : List.of(Math.max(room.from(), trajectory.completedCount()), room.to())) {
      Pose end = trajectory.startOf(i);
      if (!(zone.inside(end.position(), radius) >= -Trajectory.MAX_DEVIATION)) {
        return objection(
            "At (%.2f, %.2f) the robot would reach out of the free zone.", end.x(), end.y());
      }
    }
    return Optional.empty();
  }

  private static boolean isWidth(double metres) {
    return metres >= 0 && metres <= WIDEST_ROOM;
  }

  public Optional<String> objectionTo(Locate locate) {
    return isOnAnyMap(locate.pose())
        ? Optional.empty()
        : objection("The pose lies more than %.0f m from the map's origin.", LARGEST_COORDINATE);
  }

  public static boolean isOnAnyMap(Pose pose) {
    return Math.abs(pose.x()) <= LARGEST_COORDINATE
        && Math.abs(pose.y()) <= LARGEST_COORDINATE
        && Double.isFinite(pose.theta());
  }

  private Optional<String> objectionTo(List<Segment> segments, int from) {
    if (from + segments.size() > MOST_SEGMENTS) {
      return objection("A drive has at most %d segments.", MOST_SEGMENTS);
    }
    for (int i = 0; i < segments.size(); i++) {
      Segment s = segments.get(i);
      if (!(s.t() > 0 && s.t() <= LONGEST_SEGMENT_SECONDS)) {
        return objection(
            "Segment %d lasts %s s; a segment lasts more than 0 and at most %.0f s.",
            from + i, s.t(), LONGEST_SEGMENT_SECONDS);
      }
      if (!(Math.abs(s.v()) <= limits.speed() * ROUNDING)) {
        return objection(
            "Segment %d has %s m/s; this robot drives at most %s m/s.",
            from + i, s.v(), limits.speed());
      }
      if (!(Math.abs(s.u()) <= limits.speed() * ROUNDING)) {
        return objection(
            "Segment %d goes sideways by %s m/s; this robot drives at most %s m/s.",
            from + i, s.u(), limits.speed());
      }
      if (s.shifts() && (s.v() != 0 || s.w() != 0)) {
        return objection(
            "Segment %d goes sideways, so its v and w must be 0, not %s and %s.",
            from + i, s.v(), s.w());
      }
      if (!(Math.abs(s.w()) <= limits.turnRate() * ROUNDING)) {
        return objection(
            "Segment %d turns by %s rad/s; this robot turns by at most %s rad/s.",
            from + i, s.w(), limits.turnRate());
      }
    }
    return Optional.empty();
  }

  @FormatMethod
  private static Optional<String> objection(String sentence, Object... values) {
    return Optional.of(String.format(Locale.ROOT, sentence, values));
  }
}
