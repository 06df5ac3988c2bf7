package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;

/**
 * Makes sections of a path: fits the segments, cuts the straights where the robot may stop, and
 * gathers what lies between two such places.
 */
final class SectionFitter {
  private static final double SHORTEST = 1e-6;

  /**
   * @param start where the robot is, map frame
   * @param cornerLength metres, of {@link SegmentFitter}
   */
  List<Section> fit(
      TrafficRobot robot,
      Pose start,
      List<Waypoint> waypoints,
      double cornerLength,
      PassingPlaces passingPlaces) {
    SegmentFitter segments = new SegmentFitter(robot.speeds(), cornerLength);
    Double heading =
        waypoints.isEmpty() ? null : robot.requiredHeadingAt(waypoints.getLast().position());
    return split(
        robot,
        heading == null ? segments.fit(start, waypoints) : segments.fit(start, waypoints, heading),
        passingPlaces);
  }

  List<Section> split(TrafficRobot robot, Trajectory trajectory, PassingPlaces passingPlaces) {
    List<Section> sections = new ArrayList<>();
    OpenSection open = new OpenSection();
    Pose pose = trajectory.start();
    for (Segment whole : trajectory.segments()) {
      for (Segment piece : split(pose, whole, passingPlaces)) {
        open.add(piece, robot.sweptArea(pose, piece));
        pose = pose.advanced(piece.twist(), piece.t());
        if (passingPlaces.isPassingPlace(pose.position(), open.length)) {
          sections.add(open.closedAt(pose, robot));
          open = new OpenSection();
        }
      }
    }
    if (!open.segments.isEmpty()) {
      sections.add(open.closedAt(pose, robot));
    }
    return sections;
  }

  /** What belongs to the next section. */
  private static final class OpenSection {
    final List<Segment> segments = new ArrayList<>();
    final List<SweptArea> swept = new ArrayList<>();
    double length;

    void add(Segment piece, SweptArea area) {
      segments.add(piece);
      swept.add(area);
      length += piece.length();
    }

    Section closedAt(Pose end, TrafficRobot robot) {
      return robot.section(segments, end, SweptArea.union(swept));
    }
  }

  /** A straight in pieces that end where the robot may stop; anything else whole. */
  private static List<Segment> split(Pose from, Segment segment, PassingPlaces passingPlaces) {
    if (segment.w() != 0 || segment.v() == 0) {
      return List.of(segment);
    }
    Vec2 forward = new Vec2(1, 0).rotated(from.theta());
    List<Segment> pieces = new ArrayList<>();
    double covered = 0;
    for (double along : passingPlaces.distancesAlong(from.position(), forward, segment.length())) {
      pieces.add(new Segment(segment.v(), 0, (along - covered) / segment.v()));
      covered = along;
    }
    if (segment.length() - covered > SHORTEST) {
      pieces.add(new Segment(segment.v(), 0, (segment.length() - covered) / segment.v()));
    }
    return pieces;
  }
}
