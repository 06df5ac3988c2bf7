package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.toqa.allocation.Negotiation;
import org.toqa.allocation.NegotiationMessage;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.fleet.robot.Supervision;
import org.toqa.wording.Phrase;

/** Holds negotiations with robots' agents, and tells them what comes of each. */
final class NegotiationAgent extends AbstractBehavior<NegotiationAgent.Message> {
  private final RobotAgents robots;
  private final ActorRef<NegotiationMessage.Reply> replies;

  /** By number, those that are not over. */
  private final Map<Long, Open> negotiations = new TreeMap<>();

  private Instant now;

  /** What it is told. */
  sealed interface Message {

    /**
     * @param negotiation that has begun, and is this agent's from now on
     * @param first what it says first
     * @param now when it began
     * @param end completes when it is over
     */
    record Hold(
        Negotiation negotiation,
        List<Negotiation.Outgoing> first,
        Instant now,
        CompletableFuture<Negotiation> end)
        implements Message {}

    record Replied(NegotiationMessage.Reply reply) implements Message {}

    record Tick(Instant now) implements Message {}
  }

  private record Open(Negotiation negotiation, CompletableFuture<Negotiation> end) {}

  static Behavior<Message> of(Instant now, FleetRuntime runtime) {
    return Supervision.resuming(
        Phrase.NEGOTIATION_PART.with(),
        Message.class,
        runtime,
        Behaviors.setup(context -> new NegotiationAgent(context, now)));
  }

  private NegotiationAgent(ActorContext<Message> context, Instant now) {
    super(context);
    this.now = now;
    this.robots = RobotAgents.of(context.getSystem());
    this.replies = context.messageAdapter(NegotiationMessage.Reply.class, Message.Replied::new);
  }

  @Override
  public Receive<Message> createReceive() {
    return newReceiveBuilder().onAnyMessage(this::handle).build();
  }

  private Behavior<Message> handle(Message message) {
    switch (message) {
      case Message.Hold m -> {
        now = m.now().isAfter(now) ? m.now() : now;
        Open open = new Open(m.negotiation(), m.end());
        negotiations.put(m.negotiation().number(), open);
        goOn(open, m.first());
      }
      case Message.Replied(NegotiationMessage.Reply reply) -> {
        Open open = negotiations.get(reply.negotiation());
        if (open != null) { // else it is over: what comes late counts for nothing
          goOn(open, open.negotiation().receive(reply, now));
        }
      }
      case Message.Tick m -> {
        now = m.now();
        List.copyOf(negotiations.values())
            .forEach(open -> goOn(open, open.negotiation().letTimePass(now)));
      }
    }
    return this;
  }

  private void goOn(Open open, List<Negotiation.Outgoing> sent) {
    sent.forEach(
        outgoing ->
            robots.tell(outgoing.robot(), new RobotMessage.Negotiate(outgoing.message(), replies)));
    if (open.negotiation().isOver()) {
      negotiations.remove(open.negotiation().number());
      open.end().complete(open.negotiation());
    }
  }
}
