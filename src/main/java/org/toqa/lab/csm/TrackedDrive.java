package org.toqa.lab.csm;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import org.toqa.avoidance.MovingDisc;
import org.toqa.driving.WheelTracker;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;
import org.toqa.motion.WheelSchedule;

/**
 * A body that is kept on a moving reference by {@link WheelTracker}, over a network that delays
 * commands and answers: an answer tells where the robot was as a command came into effect, by its
 * wheels alone, or corrected by its ranges.
 */
final class TrackedDrive {
  /** Samples after the last one of a schedule. */
  private static final int SETTLING = 30;

  private final WheelTracker tracker;
  private final TwoWheelBody body;
  private final int late;
  private final @Nullable RangedPose ranged;

  /** Where the robot was by its answers as each command came into effect. */
  private final List<Pose> answers = new ArrayList<>();

  private final List<Sample> samples = new ArrayList<>();

  /** All poses are of the moment at which the command comes into effect. */
  record Sample(Pose reference, Pose answered, Pose truth, WheelCommand command) {
    double positionError() {
      return reference.distanceTo(answered);
    }

    double orientationError() {
      return Math.abs(Angles.difference(reference.theta(), answered.theta()));
    }

    double trueError() {
      return reference.distanceTo(truth);
    }
  }

  /**
   * @param delay seconds from a command to its answer
   * @param ranged what corrects the answers by ranges; null: nothing does
   */
  TrackedDrive(
      TwoWheelBody body, double delay, DifferentialLimits limits, @Nullable RangedPose ranged) {
    this.tracker = new WheelTracker(limits, CsmParameters.RESPONSE);
    this.body = body;
    this.ranged = ranged;
    this.late = (int) Math.ceil(delay / WheelCommand.SAMPLE - 1e-9);
  }

  /** Drives a whole schedule, and some samples more, to come to rest. */
  static TrackedDrive of(
      WheelSchedule schedule,
      Pose start,
      TwoWheelBody body,
      double delay,
      DifferentialLimits limits,
      @Nullable RangedPose ranged) {
    TrackedDrive drive = new TrackedDrive(body, delay, limits, ranged);
    Pose reference = start;
    List<WheelCommand> commands = schedule.commands();
    for (int i = 0; i < commands.size(); i++) {
      Twist twist = twist(commands.get(i));
      Twist then = twist(commands.get(Math.min(i + 1, commands.size() - 1)));
      drive.step(reference, twist, then, List.of());
      reference = reference.advanced(twist, WheelCommand.SAMPLE);
    }
    for (int i = 0; i < SETTLING; i++) {
      drive.step(reference, Twist.ZERO, Twist.ZERO, List.of());
    }
    return drive;
  }

  private static Twist twist(WheelCommand command) {
    return new Twist(command.v(), 0, command.w());
  }

  /**
   * One sample.
   *
   * @param reference where the robot should be at its start
   * @param twist how the reference moves in it
   * @param then how it moves in the next one
   * @param discs that ranges may meet
   */
  void step(Pose reference, Twist twist, Twist then, List<MovingDisc> discs) {
    answers.add(body.answer());
    if (ranged != null) {
      ranged.add(body.answer(), body.truth(), discs);
    }
    int answered = Math.max(0, tracker.sent() - late);
    Pose pose = ranged == null ? answers.get(answered) : ranged.pose(answered);
    WheelCommand command = tracker.next(reference, twist, then, answered, pose);
    samples.add(new Sample(reference, body.answer(), body.truth(), command));
    body.drive(command);
  }

  List<Sample> samples() {
    return samples;
  }

  TwoWheelBody body() {
    return body;
  }

  double most(ToDoubleFunction<Sample> value) {
    return samples.stream().mapToDouble(value).max().orElse(0);
  }

  /** Metres along the poses of a kind. */
  double length(Function<Sample, Pose> pose) {
    List<Vec2> line = samples.stream().map(pose).map(Pose::position).toList();
    return Vec2.lengthOf(line);
  }
}
