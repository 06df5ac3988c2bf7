package org.toqa.allocation;

import static java.util.Objects.requireNonNull;
import static java.util.stream.Collectors.toMap;
import static java.util.stream.Collectors.toSet;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.allocation.Auction.Bid;
import org.toqa.allocation.InTurn.Chosen;
import org.toqa.allocation.Situation.Given;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Each task is announced to the free robots in turn, and the least bid gets it; a robot that does
 * not answer in time is left out. Then robots change tasks that are not begun where that is
 * cheaper: see {@link Auction} and {@link Exchange}. Each auction is quick and knows nothing of the
 * next one; the exchange makes up for most of that.
 */
public final class ContractNet implements Allocator {
  /** How long bids are waited for. */
  static final Duration BIDDING_TIME = Duration.ofMillis(500);

  private final Bidding bidding;

  public ContractNet() {
    this(Bidding::computed);
  }

  ContractNet(Bidding bidding) {
    this.bidding = bidding;
  }

  @Override
  public List<Decision> allocate(Situation situation) {
    return new Round(situation).decisions();
  }

  /** One round: auctions and trade, until no robot is left for what still waits. */
  private final class Round {
    private final Situation situation;
    private final Map<String, Candidate> robots;

    /** Robots that take part in the trade: those that have a task or have answered. */
    private final Set<String> present = new TreeSet<>();

    /** By task, how its auction ended. */
    private final Map<Long, Decision.Assigned> awards = new HashMap<>();

    /** By task, the robot that has it. */
    private final Map<Long, String> holders = new HashMap<>();

    Round(Situation situation) {
      this.situation = situation;
      robots = situation.robots().stream().collect(toMap(Candidate::robot, r -> r));
      for (Given given : situation.given()) {
        holders.put(given.job().id(), given.robot());
        present.add(given.robot());
      }
    }

    List<Decision> decisions() {
      while (auctions()) {
        trade(); // may set a robot free that is the only one for a task still waiting
      }
      trade();
      WaitingReason reason = new WaitingReason(situation);
      Stream<Decision> waiting =
          situation.waiting().stream()
              .map(
                  job ->
                      holders.containsKey(job.id())
                          ? afterTrade(requireNonNull(awards.get(job.id())))
                          : reason.waits(job));
      Stream<Decision> takenOver =
          situation.given().stream()
              .filter(g -> !g.robot().equals(holders.get(g.job().id())))
              .map(g -> exchanged(g.job().id(), g.robot()));
      return Stream.concat(waiting, takenOver).toList();
    }

    /** Whether any task found a robot. */
    private boolean auctions() {
      Situation left =
          new Situation(
              situation.now(),
              situation.low(),
              situation.high(),
              situation.travel(),
              situation.chargers(),
              situation.waiting().stream().filter(j -> !holders.containsKey(j.id())).toList(),
              List.of(),
              situation.free().stream().filter(r -> !holders.containsValue(r.robot())).toList(),
              situation.inUse());
      boolean awarded = false;
      for (Decision decision : InTurn.decide(left, this::auction)) {
        if (decision instanceof Decision.Assigned award) {
          awards.put(award.job(), award);
          holders.put(award.job(), award.robots().getFirst());
          awarded = true;
        }
      }
      return awarded;
    }

    private Optional<Chosen> auction(Job job, List<Candidate> invited) {
      Set<String> names = invited.stream().map(Candidate::robot).collect(toSet());
      Auction auction = new Auction(names, situation.now().plus(BIDDING_TIME));
      bidding.replies(situation, job, invited).forEach(auction::receive);
      Set<String> silent = auction.silent();
      names.stream().filter(name -> !silent.contains(name)).forEach(present::add);
      return auction
          .winner()
          .map(bid -> new Chosen(requireNonNull(robots.get(bid.robot())), why(auction)));
    }

    private void trade() {
      List<Job> jobs =
          Stream.concat(situation.given().stream().map(Given::job), situation.waiting().stream())
              .filter(job -> holders.containsKey(job.id()))
              .toList();
      List<Candidate> traders =
          situation.robots().stream().filter(r -> present.contains(r.robot())).toList();
      List<String> names = traders.stream().map(Candidate::robot).toList();
      int[] before = jobs.stream().mapToInt(job -> names.indexOf(holders.get(job.id()))).toArray();
      int[] after = Exchange.trade(new Costs(situation), jobs, traders, before);
      IntStream.range(0, after.length)
          .forEach(i -> holders.put(jobs.get(i).id(), names.get(after[i])));
    }

    private Decision afterTrade(Decision.Assigned award) {
      String winner = award.robots().getFirst();
      return winner.equals(holders.get(award.job())) ? award : exchanged(award.job(), winner);
    }

    private Decision exchanged(long job, String from) {
      return new Decision.Assigned(
          job, List.of(requireNonNull(holders.get(job))), Phrase.TAKEN_IN_EXCHANGE.with(from));
    }
  }

  private static Sentence why(Auction auction) {
    List<Bid> bids = auction.bids();
    Sentence least =
        bids.size() == 1
            ? Phrase.ONLY_BID.with(kilojoules(bids.getFirst()))
            : Phrase.LEAST_BID.with(
                bids.size(),
                kilojoules(bids.getFirst()),
                bids.get(1).robot(),
                kilojoules(bids.get(1)));
    return auction.silent().isEmpty()
        ? least
        : Phrase.NO_ANSWER_FROM.with(least, Sentence.names(auction.silent()));
  }

  private static double kilojoules(Bid bid) {
    return bid.joules() / 1000;
  }
}
