package org.toqa.allocation;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * One task's auction (Contract Net: Smith, 1980; FIPA SC00029H).
 *
 * <ol>
 *   <li>The task is announced to the robots that are invited; they have until {@code closes}.
 *   <li>Each answers once: a bid or a refusal. What comes late, twice or uninvited does not count.
 *   <li>When all have answered, or the time is over, the least bid wins.
 * </ol>
 */
final class Auction {

  /** A robot's answer. */
  sealed interface Reply {
    String robot();

    Instant at();
  }

  /**
   * @param joules what it costs that this robot does it, as {@link Costs.Cost}
   * @param at when it came, on the auction's clock
   */
  record Bid(String robot, double joules, Instant at) implements Reply {}

  record Refusal(String robot, Instant at) implements Reply {}

  private final Set<String> silent;
  private final Instant closes;
  private final List<Bid> bids = new ArrayList<>();

  Auction(Set<String> invited, Instant closes) {
    this.silent = new HashSet<>(invited);
    this.closes = closes;
  }

  /** Whether the answer counts. */
  boolean receive(Reply reply) {
    if (reply.at().isAfter(closes) || !silent.remove(reply.robot())) {
      return false;
    }
    if (reply instanceof Bid bid) {
      bids.add(bid);
    }
    return true;
  }

  boolean isOver(Instant now) {
    return silent.isEmpty() || now.isAfter(closes);
  }

  /** Cheapest first. */
  List<Bid> bids() {
    return bids.stream()
        .sorted(Comparator.comparingDouble(Bid::joules).thenComparing(Bid::robot))
        .toList();
  }

  /** The least bid; none where nobody bids. */
  Optional<Bid> winner() {
    return bids().stream().findFirst();
  }

  /** Those that have not answered. */
  Set<String> silent() {
    return new TreeSet<>(silent);
  }
}
