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
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.allocation.Auction.Bid;
import org.toqa.allocation.SequentialAllocation.Chosen;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The contract net (Smith, 1980): each task is announced to the free robots in turn, and the least
 * bid gets it; a robot that does not answer in time is left out. Then robots change tasks that are
 * not begun where that is cheaper: see {@link Auction} and {@link Exchange}. Each auction is quick
 * and knows nothing of the next one; the exchange makes up for most of that.
 */
public final class ContractNet implements Allocator {
  /** How long bids are waited for. */
  static final Duration BIDDING_TIME = Duration.ofMillis(500);

  private final Bidding bidding;

  public ContractNet() {
    this(Bidding::computedReplies);
  }

  ContractNet(Bidding bidding) {
    this.bidding = bidding;
  }

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    return new Round(problem).decide();
  }

  /** One round: auctions and trade, until no robot is left for what still waits. */
  private final class Round {
    private final AllocationProblem problem;
    private final Map<String, Candidate> robots;

    /** Robots that take part in the trade: those that have a task or have answered. */
    private final Set<String> present = new TreeSet<>();

    /** By task, how its auction ended. */
    private final Map<Long, Decision.Assigned> awards = new HashMap<>();

    /** By task, the robot that has it. */
    private final Map<Long, String> holders = new HashMap<>();

    Round(AllocationProblem problem) {
      this.problem = problem;
      robots = problem.robots().stream().collect(toMap(Candidate::robot, r -> r));
      for (GivenTask given : problem.givenTasks()) {
        holders.put(given.task().id(), given.robot());
        present.add(given.robot());
      }
    }

    List<Decision> decide() {
      while (holdAuctions()) {
        trade(); // may set a robot free that is the only one for a task still waiting
      }
      trade();
      WaitExplainer explainer = new WaitExplainer(problem);
      Stream<Decision> waiting =
          problem.waiting().stream()
              .map(
                  task ->
                      holders.containsKey(task.id())
                          ? afterTrade(requireNonNull(awards.get(task.id())))
                          : explainer.unassigned(task));
      Stream<Decision> takenOver =
          problem.givenTasks().stream()
              .filter(g -> !g.robot().equals(holders.get(g.task().id())))
              .map(g -> exchanged(g.task().id(), g.robot()));
      return Stream.concat(waiting, takenOver).toList();
    }

    /** Whether any task found a robot. */
    private boolean holdAuctions() {
      AllocationProblem left =
          new AllocationProblem(
              problem.now(),
              problem.low(),
              problem.high(),
              problem.pathLengths(),
              problem.chargers(),
              problem.waiting().stream().filter(j -> !holders.containsKey(j.id())).toList(),
              List.of(),
              problem.freeRobots().stream().filter(r -> !holders.containsValue(r.robot())).toList(),
              problem.placesInUse());
      boolean awarded = false;
      for (Decision decision : SequentialAllocation.allocate(left, this::holdAuction)) {
        if (decision instanceof Decision.Assigned award) {
          awards.put(award.task(), award);
          holders.put(award.task(), award.robots().getFirst());
          awarded = true;
        }
      }
      return awarded;
    }

    private Optional<Chosen> holdAuction(AllocationTask task, List<Candidate> invited) {
      Set<String> names = invited.stream().map(Candidate::robot).collect(toSet());
      Auction auction = new Auction(names, problem.now().plus(BIDDING_TIME));
      bidding.replies(problem, task, invited).forEach(auction::receive);
      Set<String> silent = auction.silent();
      names.stream().filter(name -> !silent.contains(name)).forEach(present::add);
      return auction
          .winner()
          .map(bid -> new Chosen(requireNonNull(robots.get(bid.robot())), reason(auction)));
    }

    private void trade() {
      List<AllocationTask> tasks =
          Stream.concat(
                  problem.givenTasks().stream().map(GivenTask::task), problem.waiting().stream())
              .filter(task -> holders.containsKey(task.id()))
              .toList();
      List<Candidate> traders =
          problem.robots().stream().filter(r -> present.contains(r.robot())).toList();
      List<String> names = traders.stream().map(Candidate::robot).toList();
      int[] before =
          tasks.stream().mapToInt(task -> names.indexOf(holders.get(task.id()))).toArray();
      int[] after = Exchange.trade(new Costs(problem), tasks, traders, before);
      IntStream.range(0, after.length)
          .forEach(i -> holders.put(tasks.get(i).id(), names.get(after[i])));
    }

    private Decision afterTrade(Decision.Assigned award) {
      String winner = award.robots().getFirst();
      return winner.equals(holders.get(award.task())) ? award : exchanged(award.task(), winner);
    }

    private Decision exchanged(long task, String from) {
      return new Decision.Assigned(
          task, List.of(requireNonNull(holders.get(task))), Phrase.TAKEN_IN_EXCHANGE.with(from));
    }
  }

  private static Sentence reason(Auction auction) {
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
