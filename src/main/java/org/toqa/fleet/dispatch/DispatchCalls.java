package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.ActorSystem;
import org.apache.pekko.actor.typed.javadsl.AskPattern;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.fleet.CheckRefusedException;

/** Asks a dispatch; an answer that does not come in time is a failure. Any thread may call it. */
public final class DispatchCalls {
  /** Until an answer must have come. */
  public static final Duration ANSWER_LIMIT = Duration.ofSeconds(10);

  private final ActorSystem<DispatchMessage> system;
  private final OrderChecks checks;

  DispatchCalls(ActorSystem<DispatchMessage> system, OrderChecks checks) {
    this.system = system;
    this.checks = checks;
  }

  <T> CompletionStage<T> ask(Function<ActorRef<StatusReply<T>>, DispatchMessage> message) {
    return AskPattern.askWithStatus(system, message::apply, ANSWER_LIMIT, system.scheduler());
  }

  /** The same for what has to be checked first: a user has few of these at once. */
  <T> CompletionStage<T> askChecked(
      String user,
      BiFunction<OrderChecks.Check, ActorRef<StatusReply<T>>, DispatchMessage> message) {
    OrderChecks.Check check;
    try {
      check = checks.begin(user);
    } catch (CheckRefusedException e) {
      return CompletableFuture.failedFuture(e);
    }
    return this.<T>ask(replyTo -> message.apply(check, replyTo))
        .whenComplete((answer, failure) -> check.close());
  }
}
