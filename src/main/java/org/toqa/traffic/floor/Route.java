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

  static Route of(Course course, int done, int released, Pose now) {
    List<Vec2> points = new ArrayList<>(List.of(now.position()));
    int releasedPoints = 1;
    for (int i = done; i < course.size(); i++) {
      Pose pose = course.poseAfter(i);
      for (Segment segment : course.stretches().get(i).segments()) {
        if (segment.v() != 0) {
          int pieces = Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / PIECE));
          for (int k = 1; k <= pieces; k++) {
            points.add(pose.advanced(segment.twist(), segment.t() * k / pieces).position());
          }
        }
        pose = pose.advanced(segment.twist(), segment.t());
      }
      if (i < released) {
        releasedPoints = points.size();
      }
    }
    return new Route(points, releasedPoints);
  }
}
