package org.toqa.fleet.robot;

import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.BehaviorInterceptor;
import org.apache.pekko.actor.typed.SupervisorStrategy;
import org.apache.pekko.actor.typed.TypedActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.toqa.fleet.FleetRuntime;
import org.toqa.wording.Sentence;

/** How every agent is supervised. */
public final class Supervision {
  private Supervision() {}

  /**
   * A surprise in one message is logged, and the agent takes the next one; {@link AgentHealth} is
   * told of it.
   *
   * @param name the agent's, for people
   * @param messages that it takes
   */
  public static <T> Behavior<T> resuming(
      Sentence name, Class<T> messages, FleetRuntime runtime, Behavior<T> agent) {
    return Behaviors.supervise(
            Behaviors.intercept(() -> new FailureRecorder<>(name, messages, runtime), agent))
        .onFailure(SupervisorStrategy.resume());
  }

  private static final class FailureRecorder<T> extends BehaviorInterceptor<T, T> {
    private final Sentence agent;
    private final FleetRuntime runtime;

    FailureRecorder(Sentence agent, Class<T> messages, FleetRuntime runtime) {
      super(messages);
      this.agent = agent;
      this.runtime = runtime;
    }

    @Override
    public Behavior<T> aroundStart(TypedActorContext<T> context, PreStartTarget<T> target) {
      AgentHealth health = health(context);
      try {
        Behavior<T> begun = target.start(context);
        health.recordStart();
        return begun;
      } catch (RuntimeException | Error e) {
        health.recordFailedStart(agent, e);
        throw e;
      }
    }

    @Override
    public Behavior<T> aroundReceive(
        TypedActorContext<T> context, T message, ReceiveTarget<T> target) {
      try {
        return target.apply(context, message);
      } catch (VirtualMachineError | LinkageError e) {
        health(context).recordFatalError();
        throw e;
      } catch (RuntimeException | Error e) {
        health(context).recordFailure(agent, runtime.monotonicNanos());
        throw e;
      }
    }

    private AgentHealth health(TypedActorContext<T> context) {
      return AgentHealth.of(context.asJava().getSystem());
    }
  }
}
