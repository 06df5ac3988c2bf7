package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.motion.Segment;

/**
 * The rest of a robot's path as a line, map frame.
 *
 * @param released how many of the points it may drive to
 * @param deviation how far it is off that; null while it may drive none of it
 */
public record RemainingPath(List<Vec2> points, int released, @Nullable PathDeviation deviation) {

  public static final RemainingPath NONE = new RemainingPath(List.of(), 0, null);

  /** An arc is drawn in pieces of at most this angle, radians. */
  private static final double MAX_ARC_PIECE = 0.3;

  public RemainingPath {
    points = List.copyOf(points);
  }

  /**
   * @param done so many sections are completed; the robot is on the next one
   */
  static RemainingPath of(
      ReservedPath path, int done, int released, Pose now, Optional<PathDeviation> deviation) {
    List<Vec2> points = new ArrayList<>(List.of(now.position()));
    int releasedPoints = 1;
    for (int i = done; i < path.sectionCount(); i++) {
      List<Vec2> line = line(path, i);
      points.addAll(line.subList(i == done ? passed(line, now.position()) : 1, line.size()));
      if (i < released) {
        releasedPoints = points.size();
      }
    }
    return new RemainingPath(points, releasedPoints, deviation.orElse(null));
  }

  /** One section, from where it begins. */
  private static List<Vec2> line(ReservedPath path, int section) {
    Pose pose = path.poseAfter(section);
    List<Vec2> line = new ArrayList<>(List.of(pose.position()));
    for (Segment segment : path.sections().get(section).segments()) {
      if (segment.v() != 0) {
        int pieces = Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / MAX_ARC_PIECE));
        for (int k = 1; k <= pieces; k++) {
          line.add(pose.advanced(segment.twist(), segment.t() * k / pieces).position());
        }
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return line;
  }

  /** How many points of a line lie behind a robot on it: those up to the piece nearest to it. */
  private static int passed(List<Vec2> line, Vec2 robot) {
    int nearest = 1;
    double distance = Double.POSITIVE_INFINITY;
    for (int i = 1; i < line.size(); i++) {
      double here = robot.distanceToLine(line.get(i - 1), line.get(i));
      if (here < distance) {
        nearest = i;
        distance = here;
      }
    }
    return nearest;
  }
}
