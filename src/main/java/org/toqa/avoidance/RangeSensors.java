package org.toqa.avoidance;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * The range sensors of a round robot (PSD, 0.10 to 0.80 m: Tanta, "The robot"): three that look
 * forward, or any others.
 *
 * <p>Where they look is not published. Here all three sit at the foremost point of the rim, and the
 * outer ones look 20 degrees aside: while the robot comes nearer to something from 0.8 to 0.15 m,
 * an outer beam sweeps from beyond the robot's width to 0.05 m beside its middle. What is wider
 * than that hides from none of them, and what it shall drive past is seen before it must stop.
 *
 * @param beams where each sensor is and looks, metres and radians in the robot's frame, from right
 *     to left
 */
public record RangeSensors(List<Pose> beams) {

  /** Metres; what is nearer reads as this. */
  public static final double NEAREST = 0.10;

  /** Metres; the reading of a sensor that sees nothing. */
  public static final double FARTHEST = 0.80;

  /** Metres that a beam goes on behind a point, and passes beside it, where it looks through it. */
  private static final double BEHIND = 0.05;

  private static final double BESIDE = 0.01;

  private static final double MOST_OFF_SQUARE = Math.toRadians(10);

  private static final double ASIDE = Math.toRadians(20);

  /** Radians from the robot's heading, from right to left. */
  private static final List<Double> DIRECTIONS = List.of(-ASIDE, 0.0, ASIDE);

  public RangeSensors {
    beams = List.copyOf(beams);
  }

  /**
   * The three that look forward.
   *
   * @param radius of the robot, metres
   */
  public RangeSensors(double radius) {
    this(DIRECTIONS.stream().map(direction -> new Pose(radius, 0, direction)).toList());
  }

  /**
   * On the rim of a round robot, each at the angle at which it looks.
   *
   * @param radius of the robot, metres
   * @param angles radians, counter-clockwise from straight ahead, from right to left
   */
  public static RangeSensors onRim(double radius, List<Double> angles) {
    return new RangeSensors(
        angles.stream()
            .map(angle -> new Pose(radius * Math.cos(angle), radius * Math.sin(angle), angle))
            .toList());
  }

  /** Whether some look at right angles to the robot's heading, to the left and to the right. */
  public boolean lookToBothSides() {
    return beams.stream().anyMatch(beam -> isSquare(beam.theta() - Math.PI / 2))
        && beams.stream().anyMatch(beam -> isSquare(beam.theta() + Math.PI / 2));
  }

  private static boolean isSquare(double off) {
    return Math.abs(off) <= MOST_OFF_SQUARE;
  }

  /**
   * Whether a sensor looks through a point, to something behind it: nothing is there any more.
   *
   * @param ranges metres, from right to left
   * @param robot where it is; the point is in the same frame
   */
  public boolean areThrough(List<Double> ranges, Pose robot, Vec2 point) {
    for (int i = 0; i < Math.min(ranges.size(), beams.size()); i++) {
      Pose beam = robot.compose(beams.get(i));
      Vec2 seen = point.minus(beam.position()).rotated(-beam.theta());
      if (seen.x() > NEAREST && seen.x() < ranges.get(i) - BEHIND && Math.abs(seen.y()) < BESIDE) {
        return true;
      }
    }
    return false;
  }

  /**
   * The points where the sensors see something.
   *
   * @param ranges metres, from right to left; a sensor that is missing sees nothing
   * @param robot where it is; the points are in the same frame
   */
  public List<Vec2> detections(List<Double> ranges, Pose robot) {
    List<Vec2> points = new ArrayList<>();
    for (int i = 0; i < Math.min(ranges.size(), beams.size()); i++) {
      double range = ranges.get(i);
      if (range < FARTHEST) {
        points.add(robot.compose(beams.get(i)).compose(new Pose(range, 0, 0)).position());
      }
    }
    return points;
  }
}
