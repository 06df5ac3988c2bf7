package org.toqa.allocation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.function.BiFunction;
import org.toqa.allocation.Negotiation.Outgoing;
import org.toqa.allocation.NegotiationMessage.Reply;

/** A negotiation whose robots answer at once, as their agents do or as a test says. */
final class NegotiatedAllocator implements Allocator {
  private final Map<String, BiFunction<NegotiationMessage, OwnView, Optional<Reply>>> strange =
      new HashMap<>();

  /** What was said in the last negotiation, and how long it took. */
  List<String> lines = List.of();

  Duration lasted = Duration.ZERO;

  static Allocator of(Policy policy) {
    return switch (policy.method()) {
      case AllocationMethod.Computed(Allocator allocator) -> allocator;
      case AllocationMethod.Negotiated _ -> new NegotiatedAllocator();
    };
  }

  /**
   * @param answer of the robot's agent; empty: it says nothing
   */
  NegotiatedAllocator with(
      String robot, BiFunction<NegotiationMessage, OwnView, Optional<Reply>> answer) {
    strange.put(robot, answer);
    return this;
  }

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    Map<String, OwnView> views = new HashMap<>();
    problem.robots().forEach(robot -> views.put(robot.robot(), OwnView.of(robot)));
    Negotiation negotiation = new Negotiation(1, problem, true);
    Instant now = problem.now();
    Queue<Outgoing> sent = new ArrayDeque<>(negotiation.begin(now));
    while (!negotiation.isOver()) {
      if (sent.isEmpty()) {
        now = now.plus(Negotiation.ANSWER_TIME).plusMillis(1);
        sent.addAll(negotiation.letTimePass(now));
        continue;
      }
      Outgoing next = sent.remove();
      OwnView own = views.get(next.robot());
      Optional<Reply> reply =
          strange
              .getOrDefault(
                  next.robot(), (message, view) -> Optional.of(Bidder.answer(message, view)))
              .apply(next.message(), own);
      if (reply.isPresent()) {
        sent.addAll(negotiation.receive(reply.get(), now));
      }
    }
    lines = negotiation.lines().stream().map(l -> l.task() + ": " + l.text().english()).toList();
    lasted = Duration.between(problem.now(), now);
    return negotiation.decisions();
  }
}
