package org.toqa.fleet.robot;

import java.util.concurrent.Executor;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Bidder;
import org.toqa.allocation.NegotiationMessage;
import org.toqa.allocation.OwnView;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.RobotRecord;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.motion.DriveSpeeds;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A robot's part in negotiations. What it answers is computed on another thread, since its agent
 * must ping the robot meanwhile.
 */
final class TaskBidder {
  private final Executor executor;

  /**
   * @param executor on which answers are computed
   */
  TaskBidder(Executor executor) {
    this.executor = executor;
  }

  /**
   * @param hello null: the robot is not connected
   * @param state what it said last; null: nothing since
   */
  void answer(
      NegotiationMessage message,
      RobotRecord robot,
      @Nullable Hello hello,
      @Nullable State state,
      ActorRef<NegotiationMessage.Reply> replyTo) {
    OwnView own = ownView(robot, hello, state);
    executor.execute(() -> replyTo.tell(Bidder.answer(message, own)));
  }

  private static OwnView ownView(RobotRecord robot, @Nullable Hello hello, @Nullable State state) {
    if (hello == null) {
      return OwnView.unable(robot.name(), Phrase.IS_NOT_CONNECTED.with());
    }
    DriveSpeeds speeds = DriveSpeeds.DEFAULT.atMost(hello.maxSpeed(), hello.maxTurnRate());
    RobotCapabilities can =
        new RobotCapabilities(
            hello.footprint(), speeds, hello.maxLoad(), hello.sensorRange(), hello.driveKind());
    return new OwnView(
        robot.name(),
        can.allowedLoad(robot),
        can.footprint(),
        speeds.forward(),
        (state == null ? hello.pose() : state.pose()).position(),
        state == null ? null : state.battery(),
        obstacle(hello, state));
  }

  private static @Nullable Sentence obstacle(Hello hello, @Nullable State state) {
    if (!(state == null ? hello.localised() : state.localised())) {
      return Phrase.IS_NOT_LOCALISED.with();
    }
    Mode mode = state == null ? hello.mode() : state.mode();
    return switch (mode) {
      case ERROR -> Phrase.REPORTS_ERROR.with();
      case HOLDING -> Phrase.IS_HELD.with();
      case IDLE, DRIVING, FOLLOWING -> null;
    };
  }
}
