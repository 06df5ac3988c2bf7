package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.apache.pekko.actor.typed.ActorRef;
import org.toqa.allocation.AllocationMethod;
import org.toqa.allocation.AllocationProblem;
import org.toqa.allocation.Decision;
import org.toqa.allocation.Negotiation;

/** Holds a round by the floor's method: it is computed, or negotiated with robots' agents. */
final class RoundDecider {
  private final Supplier<AllocationMethod> method;
  private final ActorRef<NegotiationAgent.Message> negotiations;
  private final AtomicLong number = new AtomicLong();

  /** How many negotiations are not over. */
  private final AtomicInteger open = new AtomicInteger();

  /**
   * @param method asked at each round
   */
  RoundDecider(Supplier<AllocationMethod> method, ActorRef<NegotiationAgent.Message> negotiations) {
    this.method = method;
    this.negotiations = negotiations;
  }

  /** Time goes on, by which answers are waited for. */
  void tick(Instant now) {
    if (open.get() > 0) {
      negotiations.tell(new NegotiationAgent.Message.Tick(now));
    }
  }

  /**
   * @param executor on which it is computed
   * @param now of the time that ticks bring
   */
  CompletableFuture<DecidedRound> decide(
      AllocationProblem problem, Executor executor, Instant now) {
    return switch (method.get()) {
      case AllocationMethod.Computed(var allocator) ->
          CompletableFuture.supplyAsync(
              () -> DecidedRound.of(allocator.allocate(problem)), executor);
      case AllocationMethod.Negotiated _ -> negotiate(problem, true, executor, now);
    };
  }

  /**
   * What a round would say of the only task that waits; nobody is given it.
   *
   * @param executor on which it is computed
   * @param now of the time that ticks bring
   */
  CompletableFuture<Decision> inquire(AllocationProblem problem, Executor executor, Instant now) {
    CompletableFuture<DecidedRound> round =
        switch (method.get()) {
          case AllocationMethod.Computed _ -> decide(problem, executor, now);
          case AllocationMethod.Negotiated _ -> negotiate(problem, false, executor, now);
        };
    return round.thenApply(DecidedRound::decisions).thenApply(List::getFirst);
  }

  private CompletableFuture<DecidedRound> negotiate(
      AllocationProblem problem, boolean isBinding, Executor executor, Instant now) {
    return CompletableFuture.completedFuture(
            new Negotiation(number.incrementAndGet(), problem, isBinding))
        .thenComposeAsync(negotiation -> hold(negotiation, now), executor)
        .thenApply(over -> new DecidedRound(over.decisions(), over.lines(), over.isUnfinished()));
  }

  /** The first step looks for paths, which takes its time. */
  private CompletableFuture<Negotiation> hold(Negotiation negotiation, Instant now) {
    CompletableFuture<Negotiation> end = new CompletableFuture<>();
    List<Negotiation.Outgoing> first = negotiation.begin(now);
    open.incrementAndGet();
    negotiations.tell(new NegotiationAgent.Message.Hold(negotiation, first, now, end));
    return end.whenComplete((over, failure) -> open.decrementAndGet());
  }
}
