package org.toqa.traffic.floor;

import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.motion.Segment;

/**
 * How far a robot is off its path, where it says that it is.
 *
 * @param crossTrack metres to the left of the path, seen along it; below 0 to the right
 * @param heading radians that it faces further counter-clockwise than the path does, in (-pi, pi]
 */
public record PathDeviation(double crossTrack, double heading) {
  /** Metres that a radian counts: a turn on the spot is all in one place. */
  private static final double METRES_A_RADIAN = 0.2;

  /**
   * Of the nearest place on what is left of the section that it is on; before and behind that, of
   * its ends.
   */
  static PathDeviation of(Drive.OpenSection open, Pose robot) {
    Pose start = open.start();
    Pose nearest = start;
    double distance = Double.POSITIVE_INFINITY;
    for (Segment segment : open.segments()) {
      double share = segment.shareDone(start, robot);
      Pose here = start.advanced(segment.twist(), share * segment.t());
      double off = distance(here, robot);
      if (off < distance) {
        nearest = here;
        distance = off;
      }
      start = start.advanced(segment.twist(), segment.t());
    }
    Vec2 aside = robot.position().minus(nearest.position()).rotated(-nearest.theta());
    return new PathDeviation(aside.y(), Angles.difference(nearest.theta(), robot.theta()));
  }

  private static double distance(Pose one, Pose other) {
    double turned = Angles.difference(one.theta(), other.theta());
    return Math.hypot(one.distanceTo(other), METRES_A_RADIAN * turned);
  }
}
