package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.Comparator;
import java.util.List;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** The robots with the shortest paths to the load. */
final class NearestTeams implements TeamRanking {

  @Override
  public Comparator<Member> order(AllocationTask task) {
    return comparingDouble(Member::approach);
  }

  @Override
  public Sentence reason(AllocationTask task, List<Member> team) {
    Member leader = team.getFirst();
    return Phrase.TOO_HEAVY_FOR_ONE.with(
        team.size(), TeamRanking.shares(task, team), leader.robot().robot(), leader.approach());
  }
}
