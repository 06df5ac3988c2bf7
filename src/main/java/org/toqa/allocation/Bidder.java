package org.toqa.allocation;

import java.util.LinkedHashMap;
import java.util.Map;
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
 * What a robot's agent answers in a negotiation: a function of what it knows of its own robot, of
 * what is asked, and of the map. It knows nothing of other robots.
 */
public final class Bidder {
  private Bidder() {}

  public static Reply answer(NegotiationMessage message, OwnView own) {
    return switch (message) {
      case CallForBids call -> bids(call, own);
      case Proposal proposal -> confirmation(proposal, own);
    };
  }

  private static Bids bids(CallForBids call, OwnView own) {
    Map<Long, Quote> quotes = new LinkedHashMap<>();
    for (Lot lot : call.lots()) {
      quotes.put(lot.task().id(), quote(lot, own, call.terrain()));
    }
    return new Bids(own.robot(), call.negotiation(), call.call(), quotes);
  }

  private static Quote quote(Lot lot, OwnView own, Terrain terrain) {
    if (own.obstacle() != null) {
      return Quote.decline(Impediment.DECLINED, own.obstacle());
    }
    Candidate self = own.candidate();
    AllocationTask part = lot.together() ? lot.task().partFor(self) : lot.task();
    return new Costs(terrain).of(part, self);
  }

  /** It takes what it can still do, and nothing by which it would lose. */
  private static Confirmation confirmation(Proposal proposal, OwnView own) {
    Sentence refusal = refusal(proposal, own);
    return new Confirmation(own.robot(), proposal.negotiation(), proposal.deal(), refusal);
  }

  private static @Nullable Sentence refusal(Proposal proposal, OwnView own) {
    Lot takes = proposal.takes();
    Lot gives = proposal.gives();
    double gain = proposal.income();
    if (takes != null) {
      Quote quote = quote(takes, own, proposal.terrain());
      if (!quote.isPossible()) {
        return quote.reason();
      }
      gain -= quote.joules();
    }
    if (gives != null) {
      Quote quote = quote(gives, own, proposal.terrain());
      gain += quote.isPossible() ? quote.joules() : 0;
    }
    boolean isTrade = gives != null || proposal.income() > 0;
    return isTrade && gain < -Market.LEAST_SAVING ? Phrase.WOULD_LOSE.with() : null;
  }
}
