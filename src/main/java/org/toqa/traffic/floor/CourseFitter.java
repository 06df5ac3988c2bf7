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
 * Makes stretches of a way: fits the segments, cuts the straights where the robot may stand, and
 * gathers what lies between two such places.
 */
final class CourseFitter {
  private static final double SHORTEST = 1e-6;

  /**
   * @param start where the robot stands
   * @param cornerLength metres, of {@link SegmentFitter}
   */
  List<Stretch> fit(Mover mover, Pose start, List<Waypoint> way, double cornerLength, Halts halts) {
    SegmentFitter segments = new SegmentFitter(mover.speeds, cornerLength);
    Double heading = way.isEmpty() ? null : mover.headingAt(way.getLast().position());
    return cut(
        mover,
        heading == null ? segments.fit(start, way) : segments.fit(start, way, heading),
        halts);
  }

  List<Stretch> cut(Mover mover, Trajectory way, Halts halts) {
    List<Stretch> stretches = new ArrayList<>();
    Gathered gathered = new Gathered();
    Pose pose = way.start();
    for (Segment whole : way.segments()) {
      for (Segment piece : cut(pose, whole, halts)) {
        gathered.add(piece, mover.swept(pose, piece));
        pose = pose.advanced(piece.twist(), piece.t());
        if (halts.isHalt(pose.position(), gathered.length)) {
          stretches.add(gathered.until(pose, mover));
          gathered = new Gathered();
        }
      }
    }
    if (!gathered.segments.isEmpty()) {
      stretches.add(gathered.until(pose, mover));
    }
    return stretches;
  }

  /** What belongs to the next stretch. */
  private static final class Gathered {
    final List<Segment> segments = new ArrayList<>();
    CellSet cells = CellSet.NONE;
    double length;

    void add(Segment piece, CellSet swept) {
      segments.add(piece);
      cells = cells.and(swept);
      length += piece.length();
    }

    Stretch until(Pose end, Mover mover) {
      return new Stretch(segments, end, cells, mover.standingAt(end));
    }
  }

  /** A straight in pieces that end where the robot may stand; anything else whole. */
  private static List<Segment> cut(Pose from, Segment segment, Halts halts) {
    if (segment.w() != 0 || segment.v() == 0) {
      return List.of(segment);
    }
    Vec2 forward = new Vec2(1, 0).rotated(from.theta());
    List<Segment> pieces = new ArrayList<>();
    double covered = 0;
    for (double along : halts.along(from.position(), forward, segment.length())) {
      pieces.add(new Segment(segment.v(), 0, (along - covered) / segment.v()));
      covered = along;
    }
    if (segment.length() - covered > SHORTEST) {
      pieces.add(new Segment(segment.v(), 0, (segment.length() - covered) / segment.v()));
    }
    return pieces;
  }
}
