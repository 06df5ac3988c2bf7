package org.toqa.fleet.manager;

import java.time.InstantSource;
import java.util.List;
import java.util.function.Consumer;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.PostStop;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.Hold;
import org.toqa.fleet.OperatorHold;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.Supervision;
import org.toqa.wording.Phrase;

/**
 * What holds for all floors together: the pause. It plans nothing and keeps no task; what concerns
 * one floor is asked of that floor.
 */
final class ManagerAgent extends AbstractBehavior<ManagerMessage> {
  private final OperatorHold pause;
  private final StoreWriter writer;

  /**
   * @param stored the pause that is in force
   * @param apply lets all robots pause, or go on where it is null; called by the agent
   */
  static Behavior<ManagerMessage> of(
      FleetStore store,
      InstantSource clock,
      FleetRuntime runtime,
      @Nullable Hold stored,
      Consumer<@Nullable Hold> apply) {
    return Supervision.resuming(
        Phrase.MANAGER_PART.with(),
        ManagerMessage.class,
        runtime,
        Behaviors.setup(
            context -> new ManagerAgent(context, store, clock, runtime, stored, apply)));
  }

  private ManagerAgent(
      ActorContext<ManagerMessage> context,
      FleetStore store,
      InstantSource clock,
      FleetRuntime runtime,
      @Nullable Hold stored,
      Consumer<@Nullable Hold> apply) {
    super(context);
    AgentHealth health = AgentHealth.of(context.getSystem());
    this.writer =
        new StoreWriter(
            "manager",
            runtime,
            store::inOneTransaction,
            change -> health.recordLeftOut(change, runtime.monotonicNanos()));
    ActorRef<ManagerMessage> self = context.getSelf();
    this.pause =
        new OperatorHold(
            stored,
            writer,
            clock,
            new OperatorHold.Subject() {
              @Override
              public void apply(@Nullable Hold hold) {
                apply.accept(hold);
              }

              @Override
              public void save(@Nullable Hold hold, List<EventRecord> events) {
                store.savePause(hold, events);
              }

              @Override
              public void tell(OperatorHold.ResumeEnded ended) {
                self.tell(new ManagerMessage.ResumeEnded(ended));
              }
            },
            new OperatorHold.Telling(
                EventKind.FLEET_PAUSED,
                Phrase.ALL_PAUSED::with,
                EventKind.FLEET_RESUMED,
                Phrase.ALL_LET_GO_ON::with));
  }

  @Override
  public Receive<ManagerMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::handle)
        .onSignal(PostStop.class, signal -> stopped())
        .build();
  }

  private Behavior<ManagerMessage> handle(ManagerMessage message) {
    switch (message) {
      case ManagerMessage.SetPause m ->
          pause.set(
              m.pause(),
              m.user(),
              answer -> m.replyTo().tell(StatusReply.success(answer)),
              refusal -> m.replyTo().tell(StatusReply.error(refusal)));
      case ManagerMessage.ResumeEnded(OperatorHold.ResumeEnded ended) -> pause.end(ended);
      case ManagerMessage.FloorStarted m -> m.floor().applyPause(pause.inForce());
    }
    return this;
  }

  private Behavior<ManagerMessage> stopped() {
    writer.close();
    return this;
  }
}
