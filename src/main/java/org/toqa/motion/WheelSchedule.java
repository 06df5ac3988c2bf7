package org.toqa.motion;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Angles;
import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * Curves driven one after the other, and turns on the spot between, as samples of 30 ms for two
 * wheels: curve -> speeds ({@link VelocityPlanner}) -> (v, w) -> wheels. Each curve and each turn
 * begins and ends at rest.
 *
 * @param commands one for each sample; the last one is a stop
 */
public record WheelSchedule(List<WheelCommand> commands) {
  /** Radians; smaller turns on the spot are left out. */
  private static final double SMALLEST_TURN = 1e-6;

  public WheelSchedule {
    commands = List.copyOf(commands);
  }

  /** Seconds in all. */
  public double duration() {
    return commands.size() * WheelCommand.SAMPLE;
  }

  /**
   * Plans the samples.
   *
   * @param start heading at the start, radians, counter-clockwise from map east
   * @param goal the same at the end
   */
  public static WheelSchedule of(
      double start, List<? extends PlaneCurve> curves, double goal, DifferentialLimits limits) {
    List<WheelCommand> commands = new ArrayList<>();
    double heading = start;
    for (PlaneCurve curve : curves) {
      turn(commands, Angles.difference(heading, curve.velocity(0).angle()), limits);
      drive(commands, curve, limits);
      heading = curve.velocity(curve.end()).angle();
    }
    turn(commands, Angles.difference(heading, goal), limits);
    commands.add(WheelCommand.of(commands.size() * WheelCommand.SAMPLE, 0, 0, limits));
    return new WheelSchedule(commands);
  }

  private static VelocityPlanner planner(DifferentialLimits limits) {
    return new VelocityPlanner(limits.wheelSpeed(), limits.acceleration(), limits.jerk());
  }

  private static void drive(
      List<WheelCommand> commands, PlaneCurve curve, DifferentialLimits limits) {
    ArcLength along = new ArcLength(curve);
    VelocityProfile profile =
        planner(limits)
            .plan(along.total(), s -> limits.speedAt(curve.curvature(along.parameterAt(s))));
    double first = commands.size() * WheelCommand.SAMPLE;
    int samples = (int) Math.ceil(profile.duration() / WheelCommand.SAMPLE - 1e-9);
    for (int i = 0; i < samples; i++) {
      // what is driven and turned in the sample: headings are exact at its end
      double from = profile.distanceAt(i * WheelCommand.SAMPLE);
      double to = profile.distanceAt((i + 1) * WheelCommand.SAMPLE);
      double turned =
          Angles.difference(
              curve.velocity(along.parameterAt(from)).angle(),
              curve.velocity(along.parameterAt(to)).angle());
      commands.add(
          WheelCommand.of(
              first + i * WheelCommand.SAMPLE,
              (to - from) / WheelCommand.SAMPLE,
              turned / WheelCommand.SAMPLE,
              limits));
    }
  }

  /** Each wheel drives its part of a circle about the middle. */
  private static void turn(List<WheelCommand> commands, double angle, DifferentialLimits limits) {
    double radius = limits.track() / 2;
    if (Math.abs(angle) < SMALLEST_TURN) {
      return;
    }
    VelocityProfile profile =
        planner(limits).plan(Math.abs(angle) * radius, s -> limits.wheelSpeed());
    double first = commands.size() * WheelCommand.SAMPLE;
    for (double t = WheelCommand.SAMPLE / 2; t < profile.duration(); t += WheelCommand.SAMPLE) {
      double w = Math.copySign(profile.speedAt(t) / radius, angle);
      commands.add(WheelCommand.of(first + t - WheelCommand.SAMPLE / 2, 0, w, limits));
    }
  }

  /** Where the robot is after all samples, if each is driven exactly. */
  public Pose end(Pose start) {
    Pose pose = start;
    for (WheelCommand command : commands) {
      pose = pose.advanced(new Twist(command.v(), 0, command.w()), WheelCommand.SAMPLE);
    }
    return pose;
  }
}
