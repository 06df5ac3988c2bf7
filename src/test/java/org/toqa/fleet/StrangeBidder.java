package org.toqa.fleet;

import java.util.ArrayDeque;
import java.util.Map;
import java.util.Queue;
import java.util.function.Supplier;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.BehaviorInterceptor;
import org.apache.pekko.actor.typed.TypedActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.toqa.allocation.NegotiationMessage;
import org.toqa.allocation.NegotiationMessage.Bids;
import org.toqa.allocation.NegotiationMessage.CallForBids;
import org.toqa.allocation.NegotiationMessage.Confirmation;
import org.toqa.allocation.NegotiationMessage.Proposal;
import org.toqa.allocation.Quote;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.wording.Sentence;

/** A robot's agent that drives as usual, and takes part in negotiations as a test says. */
final class StrangeBidder<T> extends BehaviorInterceptor<T, T> {
  /** So many ticks later a late one answers: after the time is over. */
  private static final int LATE_TICKS = 15;

  private final String robot;
  private final Supplier<Habit> habit;
  private final Queue<Late<T>> late = new ArrayDeque<>();
  private long ticks;

  /** How it takes part. */
  enum Habit {
    USUAL,
    SILENT,
    LATE,
    /** It bids, and refuses whatever it gets by that. */
    REFUSES,
    /** Another program, which bids for what nobody asked it, in another's name, and less than 0. */
    STRANGE
  }

  private record Late<T>(T message, long due) {}

  @SuppressWarnings("unchecked") // every message is looked at
  StrangeBidder(String robot, Supplier<Habit> habit) {
    super((Class<T>) Object.class);
    this.robot = robot;
    this.habit = habit;
  }

  @Override
  public Behavior<T> aroundReceive(
      TypedActorContext<T> context, T message, ReceiveTarget<T> target) {
    if (message instanceof RobotMessage.Tick) {
      ticks++;
      while (!late.isEmpty() && late.element().due() <= ticks) {
        target.apply(context, late.remove().message());
      }
    }
    if (!(message instanceof RobotMessage.Negotiate negotiate)) {
      return target.apply(context, message);
    }
    return switch (habit.get()) {
      case USUAL -> target.apply(context, message);
      case SILENT -> Behaviors.same();
      case LATE -> {
        late.add(new Late<>(message, ticks + LATE_TICKS));
        yield Behaviors.same();
      }
      case REFUSES -> {
        if (!(negotiate.message() instanceof Proposal proposal)) {
          yield target.apply(context, message);
        }
        negotiate
            .replyTo()
            .tell(
                new Confirmation(
                    robot,
                    proposal.negotiation(),
                    proposal.deal(),
                    Sentence.verbatim("has changed its mind")));
        yield Behaviors.same();
      }
      case STRANGE -> {
        answerStrangely(negotiate);
        yield Behaviors.same();
      }
    };
  }

  private void answerStrangely(RobotMessage.Negotiate negotiate) {
    NegotiationMessage message = negotiate.message();
    if (message instanceof CallForBids call) {
      Map<Long, Quote> quotes = Map.of(-1L, new Quote(-1, -1, null, null));
      negotiate.replyTo().tell(new Bids("nobody", call.negotiation(), call.call(), quotes));
      negotiate.replyTo().tell(new Bids(robot, call.negotiation(), call.call(), quotes));
      negotiate.replyTo().tell(new Bids(robot, call.negotiation(), call.call(), quotes));
    }
    negotiate.replyTo().tell(new Confirmation(robot, message.negotiation(), 77, null));
  }
}
