package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotView.Readings;
import org.toqa.fleet.RobotView.Telemetry;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;

/**
 * What a robot reported last.
 *
 * @param localised whether it knows where it is
 * @param pose map frame, where it was when it knew that last; null: it never did, or a person said
 *     that it is not there any more
 * @param battery 0 to 1; null: it has not said it yet
 * @param readings {@link Readings#NONE} until it has said them
 * @param drive the number of the drive that it has, 0 without one
 * @param task the task that it drives for, if any
 * @param at when it was heard last; null: never
 */
record LastReport(
    boolean localised,
    @Nullable Pose pose,
    @Nullable Double battery,
    Readings readings,
    Mode mode,
    Role role,
    boolean moving,
    long drive,
    @Nullable Long task,
    List<Fault> errors,
    @Nullable Instant at) {

  /** The code by which a robot reports that an obstacle stops it. */
  static final String OBSTACLE = "OBSTACLE";

  /** The code by which a robot reports that it stands because it is too far beside its path. */
  static final String OFF_WAY = "OFF_WAY";

  /** The code by which a robot reports that it does not find its way through a free zone. */
  static final String ZONE_STUCK = "ZONE_STUCK";

  /** The code by which a leader reports that it is stopped for a follower's sake. */
  static final String FORMATION_STOPPED = "FORMATION_STOPPED";

  /** The code by which a follower reports that it does not hear its leader. */
  static final String LEADER_LOST = "LEADER_LOST";

  /** Of a robot that was never heard of. */
  static final LastReport NONE =
      new LastReport(
          false, null, null, Readings.NONE, Mode.IDLE, Role.ALONE, false, 0, null, List.of(), null);

  /** Metres a second that a stopped robot may still report. */
  private static final double STANDING_SPEED = 0.02;

  /** Radians a second that a stopped robot may still report. */
  private static final double STANDING_TURN = 0.05;

  LastReport {
    errors = List.copyOf(errors);
  }

  /**
   * A pose that the robot does not know itself is in no frame that anybody knows.
   *
   * @param isLocalised whether it says that it knows where it is, and may be believed
   */
  LastReport with(AgentMessage.State state, boolean isLocalised, Instant now) {
    boolean moves =
        Math.hypot(state.twist().v(), state.twist().u()) > STANDING_SPEED
            || Math.abs(state.twist().w()) > STANDING_TURN;
    return new LastReport(
        isLocalised,
        isLocalised ? state.pose() : pose,
        state.battery(),
        Readings.of(state),
        state.mode(),
        state.role(),
        moves,
        state.drive(),
        state.task(),
        state.errors(),
        now);
  }

  /** The same; what a hello does not tell stays as it was. */
  LastReport with(Hello hello, boolean isLocalised, Instant now) {
    return new LastReport(
        isLocalised,
        isLocalised ? hello.pose() : pose,
        battery,
        Readings.NONE,
        hello.mode(),
        hello.role(),
        moving,
        hello.drive(),
        hello.task(),
        errors,
        now);
  }

  LastReport withDrive(long newDrive, @Nullable Long newTask) {
    return new LastReport(
        localised, pose, battery, readings, mode, role, moving, newDrive, newTask, errors, at);
  }

  /**
   * @param newPose null: nobody knows where it is
   */
  LastReport withPose(@Nullable Pose newPose) {
    return new LastReport(
        localised, newPose, battery, readings, mode, role, moving, drive, task, errors, at);
  }

  /** Whether one of its errors has this code. */
  boolean hasError(String code) {
    for (Fault fault : errors) {
      if (fault.code().equals(code)) {
        return true;
      }
    }
    return false;
  }

  /** Whether it says that something is wrong, other than with that code. */
  boolean hasErrorBut(String code) {
    return errors.stream().anyMatch(fault -> !fault.code().equals(code));
  }

  /** What readers see of it. */
  Telemetry telemetry() {
    return new Telemetry(pose, battery, readings, errors, at);
  }
}
