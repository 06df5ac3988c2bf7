package org.toqa.app.bench;

import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.stream.Collectors;
import org.toqa.allocation.AllocationProblem;
import org.toqa.allocation.Bidder;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Negotiation;
import org.toqa.allocation.Negotiation.Outgoing;
import org.toqa.allocation.NegotiationMessage.Reply;
import org.toqa.allocation.OwnView;

/** A negotiation with robots' agents that answer at once, late or never. */
final class NegotiatedRound {
  private final Negotiation negotiation;
  private final List<String> robots;
  private final Map<String, OwnView> views;
  private final BidderFaults faults;
  private final PriorityQueue<Arrival> arrivals =
      new PriorityQueue<>(Comparator.comparing(Arrival::at).thenComparingLong(Arrival::order));
  private Instant now;
  private long sent;

  private record Arrival(Instant at, long order, Reply reply) {}

  NegotiatedRound(long number, AllocationProblem problem, BidderFaults faults) {
    this.negotiation = new Negotiation(number, problem, true);
    this.robots = problem.robots().stream().map(Candidate::robot).toList();
    this.views = problem.robots().stream().collect(Collectors.toMap(Candidate::robot, OwnView::of));
    this.faults = faults;
    this.now = problem.now();
  }

  /** The negotiation, which is over. */
  Negotiation hold() {
    answer(negotiation.begin(now));
    while (!negotiation.isOver()) {
      Arrival next = arrivals.poll();
      Instant limit = negotiation.closes().plusMillis(1);
      if (next == null || next.at().isAfter(limit)) {
        now = limit;
        if (next != null) {
          arrivals.add(next);
        }
        answer(negotiation.letTimePass(now));
      } else {
        now = next.at().isAfter(now) ? next.at() : now;
        answer(negotiation.receive(next.reply(), now));
      }
    }
    return negotiation;
  }

  /** When it was over. */
  Instant end() {
    return now;
  }

  private void answer(List<Outgoing> messages) {
    for (Outgoing message : messages) {
      int robot = robots.indexOf(message.robot());
      if (!faults.isSilent(robot, robots.size())) {
        Duration delay = faults.delay(robot);
        OwnView own = views.get(message.robot());
        if (own != null) {
          arrivals.add(new Arrival(now.plus(delay), sent++, Bidder.answer(message.message(), own)));
        }
      }
    }
  }
}
