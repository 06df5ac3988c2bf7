package org.toqa.app.bench;

import java.util.List;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.motion.DriveKind;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;

/** One robot on a path of 20 m with corners of 45 and 90 degrees. */
final class TrackingRun {
  private static final MotionLimits LIMITS = new MotionLimits(0.5, 3.5, 0.5, 3);
  private static final double CELL = 0.3;
  private static final double MAX_SECONDS = 300;

  private static final List<Vec2> CORNERS =
      List.of(
          new Vec2(4, 0),
          new Vec2(6, 2),
          new Vec2(6, 5),
          new Vec2(3, 5),
          new Vec2(1, 3),
          new Vec2(1, 0),
          new Vec2(2.5, 0));

  private final SimulatedWheels wheels;
  private final long seed;

  /**
   * @param metres length of the path
   * @param endMetres distance from its end by odometry
   * @param trueEndMetres the true distance from its end
   */
  record Report(double metres, double endMetres, double trueEndMetres) {}

  /**
   * @param seed of slip and wheel sizes
   */
  TrackingRun(SimulatedWheels wheels, long seed) {
    this.wheels = wheels;
    this.seed = seed;
  }

  Report run() {
    Pose start = new Pose(0, 0, 0);
    Trajectory planned =
        new SegmentFitter(DriveSpeeds.DEFAULT, CELL)
            .fit(start, CORNERS.stream().map(corner -> new Waypoint(corner, false)).toList());
    SegmentRunner runner =
        new SegmentRunner(
            new ReferenceTrajectory(
                start,
                planned.segments(),
                planned.segments().size(),
                PaceLimits.forSingleRobot(LIMITS)),
            DriveKind.OMNI);
    try (SimulatedBody robot = new SimulatedBody(start, wheels, seed)) {
      for (double t = 0; t < MAX_SECONDS && !runner.isAtEnd(); t += SimulatedBody.TICK) {
        robot.advance();
        robot.setCommand(runner.steer(robot.pose(), SimulatedBody.TICK, 1));
      }
      return new Report(
          planned.length(),
          planned.end().distanceTo(robot.pose()),
          planned.end().distanceTo(robot.truePose()));
    }
  }
}
