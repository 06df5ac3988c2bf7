package org.toqa.allocation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.NegotiationMessage.Bids;
import org.toqa.allocation.NegotiationMessage.CallForBids;
import org.toqa.allocation.NegotiationMessage.Confirmation;
import org.toqa.allocation.NegotiationMessage.Lot;
import org.toqa.allocation.NegotiationMessage.Proposal;
import org.toqa.allocation.NegotiationMessage.Reply;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A floor's side of a round by contract net (FIPA SC00029H) and of the trade after it (TraderBots:
 * Dias, 2004). What a task costs, robots' agents say; nothing of it is computed here.
 *
 * <ol>
 *   <li>All tasks that wait are announced to all robots that are free. Each bids or declines, with
 *       a reason; whoever says nothing in {@link #ANSWER_TIME} takes part no more.
 *   <li>The least bid wins, task by task; a load for several robots goes to the smallest team, of
 *       those that bid least for a part of it.
 *   <li>Each award is confirmed by the robot's agent. One that is refused, or not answered, comes
 *       back and is announced again, to others.
 *   <li>Robots offer what they have and have not begun; all say what it would cost them. Trades
 *       that save something are proposed ({@link Market}), and each holds when all who take part
 *       confirm it. Whom one leaves without a task, hears of those that wait still.
 * </ol>
 *
 * A function of what it is told, the time included. Every step has a limit, and there is a limited
 * number of them. Confined to one agent.
 */
public final class Negotiation {
  /** How long an answer is waited for. */
  public static final Duration ANSWER_TIME = Duration.ofSeconds(1);

  private static final int MOST_CALLS = 5;
  private static final int MOST_MARKETS = 4;

  private static final TeamAllocator AWARDS =
      new TeamAllocator(new LeastBid(), _ -> new LeastBidTeams());

  private final long number;
  private final AllocationProblem problem;
  private final boolean isBinding;
  private final ReceivedQuotes quotes;
  private final NegotiationLog log;
  private final Holdings holdings;

  /** Robots that are kept for a load that waits for more of them. */
  private Set<String> kept = Set.of();

  private Step step = Step.CALLING;
  private Instant closes = Instant.MAX;
  private int calls;
  private int markets;
  private int messages;

  /** Of the call that is open: who was asked, who has not answered, and about what. */
  private Set<String> asked = Set.of();

  private final Set<String> awaited = new TreeSet<>();
  private List<Lot> lots = List.of();

  /** By number, the contracts that are proposed. */
  private final Map<Integer, Deal> deals = new TreeMap<>();

  private enum Step {
    CALLING,
    AWARDING,
    OFFERING,
    TRADING,
    OVER
  }

  /** A message to the agent of a robot. */
  public record Outgoing(String robot, NegotiationMessage message) {}

  /**
   * @param number different from that of every other negotiation with these robots
   * @param isBinding whether tasks are awarded and traded; if not, it is only asked who would get
   *     them
   */
  public Negotiation(long number, AllocationProblem problem, boolean isBinding) {
    this.number = number;
    this.isBinding = isBinding;
    this.quotes = new ReceivedQuotes(new Costs(problem.terrain()));
    this.log = new NegotiationLog(quotes);
    this.problem = problem;
    this.holdings = new Holdings(problem, quotes);
  }

  public long number() {
    return number;
  }

  public boolean isOver() {
    return step == Step.OVER;
  }

  /** After this nothing is waited for any more that was asked. */
  public Instant closes() {
    return closes;
  }

  /** What was said, task by task. */
  public List<NegotiationLine> lines() {
    return log.lines();
  }

  /** Whether it is worth asking again soon: somebody said nothing, or took a word back. */
  public boolean isUnfinished() {
    return problem.robots().stream().map(Candidate::robot).anyMatch(quotes::isExcluded);
  }

  /** When it is over: what is decided of each task that waited, and of those that change robots. */
  public List<Decision> decisions() {
    return holdings.decisions();
  }

  public NegotiationCounts counts() {
    return log.counts();
  }

  public List<Outgoing> begin(Instant now) {
    return announce(now);
  }

  /** What comes late, twice, unasked or of another negotiation counts for nothing. */
  public List<Outgoing> receive(Reply reply, Instant now) {
    List<Outgoing> sent = new ArrayList<>(letTimePass(now));
    if (reply.negotiation() == number) {
      sent.addAll(
          switch (reply) {
            case Bids bids -> receive(bids, now);
            case Confirmation confirmation -> receive(confirmation, now);
          });
    }
    return sent;
  }

  public List<Outgoing> letTimePass(Instant now) {
    if (isOver() || !now.isAfter(closes)) {
      return List.of();
    }
    if (step == Step.CALLING || step == Step.OFFERING) {
      awaited.forEach(robot -> quotes.exclude(robot, Quote.SILENT));
      awaited.clear();
      return closeCall(now);
    }
    for (Deal deal : deals.values()) {
      for (String robot : deal.awaited()) {
        quotes.exclude(robot, Quote.SILENT);
        annul(deal, robot, Phrase.HAS_NOT_ANSWERED.with(), now);
      }
    }
    return settle(now);
  }

  // --- announcements and offers ---------------------------------------------------------------

  private List<Outgoing> announce(Instant now) {
    calls++;
    AllocationProblem open = holdings.open();
    Set<String> invited = new TreeSet<>();
    open.freeRobots().forEach(robot -> invited.add(robot.robot()));
    invited.removeIf(quotes::isExcluded);
    return open(
        Step.CALLING,
        open.waiting().stream()
            .map(task -> new Lot(task, TeamSize.isForSeveral(open, task)))
            .toList(),
        invited,
        now);
  }

  private List<Outgoing> offer(Instant now) {
    markets++;
    Set<String> traders = new TreeSet<>();
    List<Lot> offered = new ArrayList<>();
    holdings
        .tradable()
        .forEach(
            (task, holder) -> {
              if (!quotes.isExcluded(holder)) {
                offered.add(new Lot(holdings.task(task), false));
                traders.add(holder);
              }
            });
    holdings.open().freeRobots().stream()
        .map(Candidate::robot)
        .filter(robot -> !quotes.isExcluded(robot) && !kept.contains(robot))
        .forEach(traders::add);
    if (!isBinding || offered.isEmpty() || traders.size() < 2 || markets > MOST_MARKETS) {
      step = Step.OVER;
      return List.of();
    }
    return open(Step.OFFERING, offered, traders, now);
  }

  private List<Outgoing> open(Step next, List<Lot> about, Set<String> whom, Instant now) {
    step = next;
    lots = about;
    asked = lots.isEmpty() ? Set.of() : whom;
    awaited.clear();
    awaited.addAll(asked);
    if (asked.isEmpty()) {
      return closeCall(now);
    }
    closes = now.plus(ANSWER_TIME);
    CallForBids call = new CallForBids(number, ++messages, lots, problem.terrain());
    return asked.stream().map(robot -> new Outgoing(robot, call)).toList();
  }

  private List<Outgoing> receive(Bids bids, Instant now) {
    boolean isCalling = step == Step.CALLING || step == Step.OFFERING;
    if (!isCalling || bids.call() != messages || !awaited.remove(bids.robot())) {
      return List.of();
    }
    for (Lot lot : lots) {
      quotes.put(bids.robot(), lot.task().id(), quote(bids, lot.task()));
    }
    return awaited.isEmpty() ? closeCall(now) : List.of();
  }

  /** What its agent says of it; whoever may not have it has no say. */
  private static Quote quote(Bids bids, AllocationTask task) {
    if (!task.allows(bids.robot())) {
      return Quote.decline(Impediment.NOT_CHOSEN, Phrase.IS_NOT_CHOSEN.with());
    }
    Quote quote = bids.quotes().get(task.id());
    return quote != null && quote.isSound()
        ? quote
        : Quote.decline(Impediment.DECLINED, Phrase.MAKES_NO_BID.with());
  }

  private List<Outgoing> closeCall(Instant now) {
    return step == Step.CALLING ? award(now) : trade(now);
  }

  // --- awards ---------------------------------------------------------------------------------

  private List<Outgoing> award(Instant now) {
    if (!asked.isEmpty()) {
      lots.forEach(lot -> log.addAnnouncement(lot.task().id(), asked, now));
    }
    TeamAllocator.Outcome outcome = AWARDS.decide(holdings.open());
    kept = outcome.kept();
    List<Outgoing> sent = new ArrayList<>();
    begin(Step.AWARDING, now);
    for (Decision decision : outcome.decisions()) {
      holdings.setUndecided(decision);
      if (decision instanceof Decision.Assigned award) {
        sent.addAll(propose(award));
      }
    }
    return isBinding && !deals.isEmpty() ? sent : settle(now);
  }

  private void begin(Step next, Instant now) {
    step = next;
    closes = now.plus(ANSWER_TIME);
    deals.clear();
  }

  private List<Outgoing> propose(Decision.Assigned award) {
    int deal = ++messages;
    deals.put(deal, Deal.of(award));
    Lot lot = new Lot(holdings.task(award.task()), award.robots().size() > 1);
    return award.robots().stream()
        .map(
            robot ->
                new Outgoing(robot, new Proposal(number, deal, lot, null, 0, problem.terrain())))
        .toList();
  }

  // --- trades ---------------------------------------------------------------------------------

  private List<Outgoing> trade(Instant now) {
    Map<Long, String> offered = new TreeMap<>();
    for (Lot lot : lots) {
      String holder = holdings.holder(lot.task().id());
      if (quotes.of(lot.task().id(), holder).isPossible()) {
        offered.put(lot.task().id(), holder);
        log.addOffer(lot.task().id(), holder, without(holder), now);
      }
    }
    List<String> traders = asked.stream().filter(mayTrade(offered)).toList();
    List<Outgoing> sent = new ArrayList<>();
    begin(Step.TRADING, now);
    for (Trade trade : new Market(offered, traders, quotes).clear()) {
      sent.addAll(propose(trade));
    }
    return deals.isEmpty() ? settle(now) : sent;
  }

  private List<String> without(String holder) {
    return asked.stream().filter(robot -> !robot.equals(holder)).toList();
  }

  /** Whoever answered, and has either nothing or something that he offers. */
  private Predicate<String> mayTrade(Map<Long, String> offered) {
    Set<String> engaged = holdings.engagedRobots();
    return robot ->
        !quotes.isExcluded(robot) && (offered.containsValue(robot) || !engaged.contains(robot));
  }

  private List<Outgoing> propose(Trade trade) {
    int deal = ++messages;
    deals.put(deal, Deal.of(trade));
    return trade.robots().stream()
        .map(
            robot ->
                new Outgoing(
                    robot,
                    new Proposal(
                        number,
                        deal,
                        lot(trade, leg -> leg.buyer().equals(robot)),
                        lot(trade, leg -> leg.seller().equals(robot)),
                        trade.income(robot),
                        problem.terrain())))
        .toList();
  }

  private @Nullable Lot lot(Trade trade, Predicate<Trade.Leg> which) {
    return trade.legs().stream()
        .filter(which)
        .map(leg -> new Lot(holdings.task(leg.task()), false))
        .findFirst()
        .orElse(null);
  }

  // --- confirmations --------------------------------------------------------------------------

  private List<Outgoing> receive(Confirmation confirmation, Instant now) {
    Deal deal = deals.get(confirmation.deal());
    if (deal == null || isOver() || !deal.takeAnswer(confirmation.robot())) {
      return List.of();
    }
    Sentence refusal = confirmation.refusal();
    if (refusal != null) {
      quotes.exclude(confirmation.robot(), Quote.decline(Impediment.DECLINED, refusal));
      annul(deal, confirmation.robot(), refusal, now);
    }
    return deals.values().stream().anyMatch(Deal::isOpen) ? List.of() : settle(now);
  }

  private void annul(Deal deal, String robot, Sentence why, Instant now) {
    if (!deal.isVoid()) {
      deal.annul();
      log.addFailure(deal, robot, why, now);
    }
  }

  /** All contracts hold or are void: what comes next. */
  private List<Outgoing> settle(Instant now) {
    boolean isAnyVoid = deals.values().stream().anyMatch(Deal::isVoid);
    boolean isAnyHeld = deals.values().stream().anyMatch(deal -> !deal.isVoid());
    deals.values().stream().filter(deal -> !deal.isVoid()).forEach(deal -> conclude(deal, now));
    deals.clear();
    boolean mayAnnounce = calls < MOST_CALLS && !holdings.open().waiting().isEmpty();
    if (step == Step.AWARDING) {
      return isAnyVoid && mayAnnounce ? announce(now) : offer(now);
    }
    if (isAnyHeld && mayAnnounce) {
      return announce(now); // perhaps to a robot that the others could not do without
    }
    if (isAnyVoid) {
      return offer(now);
    }
    step = Step.OVER;
    return List.of();
  }

  private void conclude(Deal deal, Instant now) {
    Trade trade = deal.trade();
    if (trade == null) {
      Decision.Assigned award = deal.award();
      holdings.give(award.task(), award.robots(), award.reason());
      log.addAward(award, now);
      return;
    }
    for (Trade.Leg leg : trade.legs()) {
      Sentence why =
          trade.legs().size() == 1
              ? Phrase.BOUGHT_FROM.with(leg.seller(), leg.price() / 1000)
              : Phrase.TAKEN_IN_TRADE.with(leg.seller(), leg.price() / 1000, trade.robots().size());
      holdings.give(leg.task(), List.of(leg.buyer()), why);
    }
    log.addTrade(trade, now);
  }
}
