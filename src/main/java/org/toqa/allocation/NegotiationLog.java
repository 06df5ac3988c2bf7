package org.toqa.allocation;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Puts a negotiation into words, task by task. */
final class NegotiationLog {
  /** Of so many robots it is said what each answered; of more, how many they are. */
  private static final int NAMED = 5;

  private final ReceivedQuotes quotes;
  private final List<NegotiationLine> lines = new ArrayList<>();
  private NegotiationCounts counts = NegotiationCounts.NONE;

  NegotiationLog(ReceivedQuotes quotes) {
    this.quotes = quotes;
  }

  NegotiationCounts counts() {
    return counts;
  }

  List<NegotiationLine> lines() {
    return List.copyOf(lines);
  }

  /** A task was announced, and this is what came of it. */
  void addAnnouncement(long task, Collection<String> invited, Instant at) {
    addAnswers(task, Phrase.ANNOUNCED_TO.with(invited.size()), invited, at);
  }

  /** Who has a task has offered it to others. */
  void addOffer(long task, String seller, Collection<String> others, Instant at) {
    double own = kilojoules(quotes.of(task, seller).joules());
    addAnswers(task, Phrase.OFFERED_FOR.with(seller, own), others, at);
  }

  private void addAnswers(long task, Sentence begin, Collection<String> robots, Instant at) {
    List<String> bidders =
        robots.stream()
            .filter(robot -> quotes.of(task, robot).isPossible())
            .sorted(
                Comparator.comparingDouble((String robot) -> quotes.of(task, robot).joules())
                    .thenComparing(Comparator.naturalOrder()))
            .toList();
    List<Sentence> parts = new ArrayList<>(List.of(begin));
    parts.add(
        bidders.isEmpty()
            ? Phrase.NO_BIDS.with()
            : Phrase.BIDS_ARE.with(
                listed(
                    bidders,
                    robot ->
                        Phrase.BID_OF.with(robot, kilojoules(quotes.of(task, robot).joules())))));
    List<String> declining = with(task, robots, false);
    if (!declining.isEmpty()) {
      parts.add(Phrase.DECLINED_ARE.with(listed(declining, robot -> reason(task, robot))));
    }
    List<String> silent = with(task, robots, true);
    counts = counts.plusAnswers(bidders.size(), declining.size(), silent.size());
    if (!silent.isEmpty()) {
      parts.add(Phrase.SILENT_ARE.with(listed(silent, Sentence::verbatim)));
    }
    add(task, Sentence.joined(Phrase.LISTED_APART, parts), at);
  }

  private List<String> with(long task, Collection<String> robots, boolean isSilent) {
    return robots.stream()
        .filter(robot -> !quotes.of(task, robot).isPossible())
        .filter(robot -> (quotes.of(task, robot).impediment() == Impediment.SILENT) == isSilent)
        .sorted()
        .toList();
  }

  private Sentence reason(long task, String robot) {
    Sentence reason = quotes.of(task, robot).reason();
    return reason == null ? Sentence.verbatim(robot) : Phrase.ROBOT_AND_CLAUSE.with(robot, reason);
  }

  private static Sentence listed(List<String> robots, Function<String, Sentence> words) {
    Sentence named =
        Sentence.joined(Phrase.LISTED, robots.stream().limit(NAMED).map(words).toList());
    return robots.size() <= NAMED ? named : Phrase.AND_MORE.with(named, robots.size() - NAMED);
  }

  void addAward(Decision.Assigned award, Instant at) {
    counts = counts.plusAward();
    add(award.task(), Phrase.AWARD_CONFIRMED.with(Sentence.names(award.robots())), at);
  }

  /** A contract is void. */
  void addFailure(Deal deal, String robot, Sentence why, Instant at) {
    boolean isTrade = deal.trade() != null;
    counts = isTrade ? counts.plusTradeVoid() : counts.plusAwardReturned();
    Phrase phrase = isTrade ? Phrase.TRADE_FELL_THROUGH : Phrase.AWARD_CAME_BACK;
    Sentence text = phrase.with(Phrase.ROBOT_AND_CLAUSE.with(robot, why));
    deal.tasks().forEach(task -> add(task, text, at));
  }

  void addTrade(Trade trade, Instant at) {
    counts = counts.plusTrade(trade);
    for (Trade.Leg leg : trade.legs()) {
      Sentence sale = Phrase.SOLD_TO.with(leg.seller(), leg.buyer(), kilojoules(leg.price()));
      add(
          leg.task(),
          trade.legs().size() == 1
              ? sale
              : Phrase.ONE_OF_SALES.with(
                  sale, Sentence.names(trade.robots()), kilojoules(trade.saved())),
          at);
    }
  }

  private void add(long task, Sentence text, Instant at) {
    lines.add(new NegotiationLine(task, at, text));
  }

  private static double kilojoules(double joules) {
    return joules / 1000;
  }
}
