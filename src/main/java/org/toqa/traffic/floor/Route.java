package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.motion.Segment;

/**
 * The rest of a robot's way as a line, map frame.
 *
 * @param released how many of the points it may drive to
 */
public record Route(List<Vec2> points, int released) {

  public static final Route NONE = new Route(List.of(), 0);

  /** An arc is drawn in pieces of at most this angle, radians. */
  private static final double PIECE = 0.3;

  public Route {
    points = List.copyOf(points);
  }

  /**
   * @param done so many stretches are completed; the robot is on the next one
   */
  static Route of(Course course, int done, int released, Pose now) {
    List<Vec2> points = new ArrayList<>(List.of(now.position()));
    int releasedPoints = 1;
    for (int i = done; i < course.size(); i++) {
      List<Vec2> line = line(course, i);
      points.addAll(line.subList(i == done ? passed(line, now.position()) : 1, line.size()));
      if (i < released) {
        releasedPoints = points.size();
      }
    }
    return new Route(points, releasedPoints);
  }

  /** One stretch, from where it begins. */
  private static List<Vec2> line(Course course, int stretch) {
    Pose pose = course.poseAfter(stretch);
    List<Vec2> line = new ArrayList<>(List.of(pose.position()));
    for (Segment segment : course.stretches().get(stretch).segments()) {
      if (segment.v() != 0) {
        int pieces = Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / PIECE));
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
