package org.toqa.allocation;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/**
 * What a floor's side of a negotiation says to robots' agents; they answer a {@link Reply}.
 *
 * <ol>
 *   <li>{@link CallForBids}: these tasks wait, or are offered by who has them. The agent answers
 *       {@link Bids} in time, or counts as silent.
 *   <li>{@link Proposal}: this is awarded to it, or changes hands. The agent looks at its robot
 *       again and answers {@link Confirmation}. Without one in time the proposal is void.
 * </ol>
 */
public sealed interface NegotiationMessage {

  /** The number of the negotiation. */
  long negotiation();

  /**
   * A task that can be had.
   *
   * @param together whether it is for several robots, so that each bids for what it can carry of it
   */
  record Lot(AllocationTask task, boolean together) {}

  /**
   * @param call the number of the call within the negotiation
   */
  record CallForBids(long negotiation, int call, List<Lot> lots, Terrain terrain)
      implements NegotiationMessage {
    public CallForBids {
      lots = List.copyOf(lots);
    }
  }

  /**
   * A contract for one robot.
   *
   * @param deal the number of the deal within the negotiation; others may have a part in it
   * @param takes what it is to carry from now on; null: nothing
   * @param gives what it has, and another robot takes; null: nothing
   * @param income joules that it is paid, less what it pays
   */
  record Proposal(
      long negotiation,
      int deal,
      @Nullable Lot takes,
      @Nullable Lot gives,
      double income,
      Terrain terrain)
      implements NegotiationMessage {}

  /** What a robot's agent answers. */
  sealed interface Reply {
    String robot();

    /** The number of the negotiation. */
    long negotiation();
  }

  /**
   * @param quotes by task of the call
   */
  record Bids(String robot, long negotiation, int call, Map<Long, Quote> quotes) implements Reply {
    public Bids {
      quotes = Map.copyOf(quotes);
    }
  }

  /**
   * @param refusal why it does not, follows the robot's name in a sentence; null: it does
   */
  record Confirmation(String robot, long negotiation, int deal, @Nullable Sentence refusal)
      implements Reply {}
}
