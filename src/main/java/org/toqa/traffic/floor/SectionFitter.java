package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.motion.Segment;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;

/**
 * Makes sections of a path: fits the segments, cuts the straights where the robot may stop, slows
 * down where the floor has speed limits, and gathers what lies between two such places.
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
    List<Part> parts = new ArrayList<>();
    Part open = new Part();
    Pose pose = trajectory.start();
    for (Segment whole : trajectory.segments()) {
      for (Segment piece : split(pose, whole, passingPlaces)) {
        for (Segment limited : robot.limited(pose, piece)) {
          SweptArea area = robot.sweptArea(pose, limited);
          pose = pose.advanced(limited.twist(), limited.t());
          open.add(limited, area, pose);
        }
        if (passingPlaces.isPassingPlace(pose.position(), open.length)) {
          open.endsHalfway = passingPlaces.isHalfway(pose.position());
          parts.add(open);
          open = new Part();
        }
      }
    }
    if (!open.segments.isEmpty()) {
      parts.add(open);
    }
    joinThroughCells(parts);
    return parts.stream()
        .map(
            part ->
                robot.section(
                    part.segments,
                    Objects.requireNonNull(part.end),
                    SweptArea.union(part.swept),
                    part.endsHalfway))
        .toList();
  }

  /**
   * Before a cell that is gone through without a place to stop in it, as on an arc, nobody stops
   * halfway: it would keep the way through that cell, where another could come.
   */
  private static void joinThroughCells(List<Part> parts) {
    if (!parts.isEmpty()) {
      parts.getLast().endsHalfway = false;
    }
    for (int i = parts.size() - 2; i >= 0; i--) {
      if (parts.get(i).endsHalfway && parts.get(i + 1).endsHalfway) {
        parts.get(i).join(parts.remove(i + 1));
      }
    }
  }

  /** What is to be a section. */
  private static final class Part {
    final List<Segment> segments = new ArrayList<>();
    final List<SweptArea> swept = new ArrayList<>();
    double length;
    @Nullable Pose end;
    boolean endsHalfway;

    void add(Segment piece, SweptArea area, Pose pieceEnd) {
      segments.add(piece);
      swept.add(area);
      length += piece.length();
      end = pieceEnd;
    }

    void join(Part next) {
      segments.addAll(next.segments);
      swept.addAll(next.swept);
      length += next.length;
      end = next.end;
    }
  }

  /** A straight in pieces that end where the robot may stop; anything else whole. */
  private static List<Segment> split(Pose from, Segment segment, PassingPlaces passingPlaces) {
    if (segment.w() != 0 || segment.speed() == 0) {
      return List.of(segment);
    }
    Vec2 ahead =
        new Vec2(segment.v(), segment.u()).times(1 / segment.speed()).rotated(from.theta());
    List<Segment> pieces = new ArrayList<>();
    double covered = 0;
    for (double along : passingPlaces.distancesAlong(from.position(), ahead, segment.length())) {
      pieces.add(segment.lasting((along - covered) / segment.speed()));
      covered = along;
    }
    if (segment.length() - covered > SHORTEST) {
      pieces.add(segment.lasting((segment.length() - covered) / segment.speed()));
    }
    return pieces;
  }
}
