package org.toqa.allocation;

/**
 * How often what happened in negotiations.
 *
 * @param bids of robots for tasks, those for tasks that others offered included
 * @param declined the same, where a robot said why it does not bid
 * @param silent the same, where it said nothing in time
 * @param awards that were confirmed
 * @param awardsReturned that were refused, or not answered
 * @param trades that were confirmed by all who took part
 * @param tradesVoid that were not
 * @param tasksTraded in them
 * @param largestTrade how many robots took part in one
 * @param joulesSaved by trades
 */
public record NegotiationCounts(
    long bids,
    long declined,
    long silent,
    long awards,
    long awardsReturned,
    long trades,
    long tradesVoid,
    long tasksTraded,
    int largestTrade,
    double joulesSaved) {

  public static final NegotiationCounts NONE = new NegotiationCounts(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  public NegotiationCounts plus(NegotiationCounts other) {
    return new NegotiationCounts(
        bids + other.bids,
        declined + other.declined,
        silent + other.silent,
        awards + other.awards,
        awardsReturned + other.awardsReturned,
        trades + other.trades,
        tradesVoid + other.tradesVoid,
        tasksTraded + other.tasksTraded,
        Math.max(largestTrade, other.largestTrade),
        joulesSaved + other.joulesSaved);
  }

  NegotiationCounts plusAnswers(int moreBids, int moreDeclined, int moreSilent) {
    return plus(new NegotiationCounts(moreBids, moreDeclined, moreSilent, 0, 0, 0, 0, 0, 0, 0));
  }

  NegotiationCounts plusAward() {
    return plus(new NegotiationCounts(0, 0, 0, 1, 0, 0, 0, 0, 0, 0));
  }

  NegotiationCounts plusAwardReturned() {
    return plus(new NegotiationCounts(0, 0, 0, 0, 1, 0, 0, 0, 0, 0));
  }

  NegotiationCounts plusTrade(Trade trade) {
    return plus(
        new NegotiationCounts(
            0, 0, 0, 0, 0, 1, 0, trade.legs().size(), trade.robots().size(), trade.saved()));
  }

  NegotiationCounts plusTradeVoid() {
    return plus(new NegotiationCounts(0, 0, 0, 0, 0, 0, 1, 0, 0, 0));
  }
}
