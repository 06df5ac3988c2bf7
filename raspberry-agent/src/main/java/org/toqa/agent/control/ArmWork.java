package org.toqa.agent.control;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmCommand;
import org.toqa.arm.ArmControl;
import org.toqa.arm.ArmFailure;
import org.toqa.arm.ArmOutcome;
import org.toqa.arm.ArmReading;
import org.toqa.arm.InverseKinematics;
import org.toqa.arm.Reach;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.ActFailure;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Frame;

/** What the robot's arm does for the server. For the thread of the ticks. */
final class ArmWork {

  private static final Fault HELD_UP =
      new Fault(
          "ARM_STALLED",
          "The arm does not come to its rest: something holds it, or its joints do not turn.",
          true);

  private final Arm arm;
  private final ArmControl control;
  private ArmReading reading;

  /** What it does, until how that ended is in the journal. */
  private @Nullable Act order;

  private @Nullable ArmOutcome outcome;

  ArmWork(Arm arm, ArmReading reading) {
    this.arm = arm;
    this.reading = reading;
    this.control = new ArmControl(arm, reading);
  }

  /**
   * Begins; a place that is out of reach from here ends it at once.
   *
   * @param robot where that stands, map frame
   * @param isRepeated whether the same was begun before and did not end
   */
  void begin(Act act, Pose robot, boolean isRepeated) {
    order = act;
    Vec2 target =
        act.frame() == Frame.ROBOT
            ? act.target()
            : robot.relative(new Pose(act.target().x(), act.target().y(), 0)).position();
    switch (InverseKinematics.solve(arm, target)) {
      case Reach.Within reach -> control.begin(act.action(), control.nearest(reach), isRepeated);
      case Reach.Outside(Reach.Reason reason, double _) -> {
        control.cancel();
        outcome = new ArmOutcome(ArmFailure.of(reason), null);
      }
    }
  }

  /** It stands, and does what it was told no more; whether it can be folded is open again. */
  void cancel() {
    order = null;
    outcome = null;
    control.cancel();
  }

  /** Brings it to its rest, if it does nothing. */
  void fold() {
    control.fold();
  }

  /**
   * One tick.
   *
   * @param seconds since the last one
   * @param mayMove false: it is held, or the robot's body has a fault
   */
  ArmCommand advance(double seconds, ArmReading now, boolean mayMove) {
    reading = now;
    ArmCommand command = control.advance(seconds, now, mayMove);
    control.takeOutcome().ifPresent(ended -> outcome = ended);
    return command;
  }

  /** How what it does ended, until {@link #endAct}. */
  Optional<ActEnd> end() {
    Act act = order;
    ArmOutcome ended = outcome;
    return act == null || ended == null
        ? Optional.empty()
        : Optional.of(
            new ActEnd(
                act.seq(),
                act.task(),
                act.phase(),
                act.action(),
                ended.failure() == null ? null : failure(ended.failure()),
                ended.weight()));
  }

  private static ActFailure failure(ArmFailure failure) {
    String text =
        switch (failure) {
          case TOO_FAR -> "The place is too far for the arm.";
          case TOO_NEAR -> "The place is too near to the arm's shoulder.";
          case JOINT_LIMITS -> "The arm's joints cannot turn so.";
          case NOTHING_GRASPED -> "There was nothing in the hand after it had closed.";
          case NOTHING_HELD -> "There is nothing in the hand.";
          case HAND_FULL -> "There is something in the hand already.";
          case TOO_HEAVY -> "What the hand grasped is heavier than the arm may lift.";
          case NOT_RELEASED -> "The load hangs on the open hand.";
          case STALLED -> "The arm's joints do not follow.";
        };
    return new ActFailure(failure.name(), text);
  }

  /** How it ended is in the journal. */
  void endAct() {
    order = null;
    outcome = null;
  }

  /** What it does; empty: nothing. */
  Optional<Act> order() {
    return Optional.ofNullable(order);
  }

  /** Something keeps it from its rest; it stands until {@link #cancel}. */
  Optional<Fault> fault() {
    return control.hasFailedToFold() ? Optional.of(HELD_UP) : Optional.empty();
  }

  boolean isFolded() {
    return control.isFolded();
  }

  /** Whether it does nothing and stands. */
  boolean isAtRest() {
    return order == null && control.isStanding();
  }

  Arm arm() {
    return arm;
  }

  ArmState state() {
    return new ArmState(
        reading.angles(),
        reading.isHolding() ? reading.load() : null,
        order == null ? null : order.seq(),
        control.step().orElse(null));
  }
}
