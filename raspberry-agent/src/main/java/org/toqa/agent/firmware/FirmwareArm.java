package org.toqa.agent.firmware;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ArmDrive;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.firmware.ArmStatus.State;
import org.toqa.agent.firmware.FirmwareCommand.ArmMove;
import org.toqa.agent.firmware.FirmwareCommand.ArmPoll;
import org.toqa.arm.ArmCommand;
import org.toqa.arm.ArmReading;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;

/**
 * The arm under a microcontroller: that is told where the joints shall be, and finds the way there
 * within their limits by itself. Its frames go between those of the wheels, one by one.
 */
final class FirmwareArm implements ArmDrive {

  /** Frames of a robot that drives, 0.5 s: its arm is at its rest. */
  private static final int FRAMES_WHILE_IT_DRIVES = 25;

  private final ArmSettings settings;
  private final FrameTransport transport;
  private @Nullable ArmStatus status;
  private @Nullable ArmCommand wanted;
  private long wantedNanos;
  private int framesSince;

  /** On the way to which the joints have not followed; null: that is known, or they do again. */
  private @Nullable JointAngles stalledGoal;

  private double expectedLoad;

  FirmwareArm(ArmSettings settings, FrameTransport transport) {
    this.settings = settings;
    this.transport = transport;
  }

  ArmSettings settings() {
    return settings;
  }

  @Override
  public ArmReading reading() {
    ArmStatus now = status;
    if (now == null) {
      throw new IllegalStateException("nothing is known of the arm");
    }
    return new ArmReading(now.angles(), now.handClosed(), now.load(), stalledGoal != null);
  }

  @Override
  public ArmReading exchange(ArmCommand command, long nanos) {
    wanted = command;
    wantedNanos = nanos;
    if (!move(command).goal().equals(stalledGoal)) {
      stalledGoal = null;
    }
    return reading();
  }

  @Override
  public void expectLoad(double kilograms) {
    if (kilograms != expectedLoad) {
      expectedLoad = kilograms;
      transport.expectLoad(kilograms);
    }
  }

  /**
   * The frame that is its own turn; empty: the wheels have it.
   *
   * @param isDriving whether the wheels turn
   */
  Optional<FirmwareCommand> next(boolean isDriving, long nanos) {
    if (framesSince < (isDriving ? FRAMES_WHILE_IT_DRIVES : 1)) {
      return Optional.empty();
    }
    ArmStatus now = status;
    ArmCommand command = wanted;
    if (now != null && command != null && now.state() == State.STALLED) {
      return Optional.of(move(now.angles(), command)); // another goal: it may move again
    }
    return Optional.of(
        isDriving || command == null || nanos - wantedNanos > Chassis.COMMAND_LIFE_NANOS
            ? new ArmPoll()
            : move(command));
  }

  void recordSent(FirmwareCommand command) {
    framesSince = command.isOfArm() ? 0 : framesSince + 1;
  }

  private ArmMove move(ArmCommand command) {
    return move(command.goal(), command);
  }

  private ArmMove move(JointAngles goal, ArmCommand command) {
    return new ArmMove(
        new JointAngles(
            limited(goal.shoulder(), settings.arm().shoulder()),
            limited(goal.elbow(), settings.arm().elbow())),
        command.handClosed(),
        command.onward());
  }

  /** As the frame has it, so that it can be compared with what comes back. */
  private static double limited(double angle, JointLimits joint) {
    return Math.rint(1e6 * Math.clamp(angle, joint.least(), joint.most())) / 1e6;
  }

  void update(ArmStatus now) {
    if (now.state() == State.UNKNOWN) {
      return;
    }
    ArmStatus before = status;
    if (now.state() != State.STALLED) {
      stalledGoal = null;
    } else if (before == null || before.state() != State.STALLED) {
      stalledGoal = now.goal();
    }
    status = now;
  }

  boolean isKnown() {
    return status != null;
  }

  /** Whether it must be spoken to at every tick. */
  boolean isBusy() {
    ArmStatus now = status;
    ArmCommand command = wanted;
    if (now == null) {
      return true;
    }
    if (command == null) {
      return false;
    }
    ArmMove move = move(command);
    return now.state() == State.MOVING
        || now.handClosed() != move.handClosed()
        || (move.onward() && now.state() == State.STANDING && now.progress() < 1)
        || !move.goal().equals(now.goal());
  }

  @Override
  public void close() {
    // its frames end with those of the body
  }
}
