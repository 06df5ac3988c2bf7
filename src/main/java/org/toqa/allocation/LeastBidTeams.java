package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.Comparator;
import java.util.List;
import org.toqa.wording.Sentence;

/** The robots with the least bids for a part; the nearest of them leads. */
final class LeastBidTeams implements TeamRanking {

  @Override
  public Comparator<Member> order(AllocationTask task) {
    return comparingDouble((Member member) -> member.quote().joules())
        .thenComparing(member -> member.robot().robot());
  }

  @Override
  public Comparator<Member> leaderFirst(AllocationTask task) {
    return comparingDouble(Member::approach);
  }

  @Override
  public Sentence reason(AllocationTask task, List<Member> team) {
    return TeamRanking.ledByNearest(task, team);
  }
}
