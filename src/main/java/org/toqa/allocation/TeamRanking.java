package org.toqa.allocation;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Who comes first into a team, of the robots that are free and can carry their share. */
interface TeamRanking {

  /**
   * @param quote for its part of the load
   */
  record Member(Candidate robot, Quote quote) {
    /** Its path to the load, metres. */
    double approach() {
      return quote.approach();
    }
  }

  /** What each has of the load, in words. */
  static Sentence shares(AllocationTask task, List<Member> team) {
    List<Candidate> robots = team.stream().map(Member::robot).toList();
    List<Double> shares = TeamSize.shares(task.load(), TeamSize.maxLoads(robots));
    double first = shares.getFirst();
    return shares.stream().allMatch(share -> Math.abs(share - first) < TeamSize.ROUNDING)
        ? Phrase.SHARE_OF_EACH.with(first)
        : Sentence.joined(
            Phrase.LISTED,
            IntStream.range(0, robots.size())
                .mapToObj(i -> Phrase.SHARE_OF.with(robots.get(i).robot(), shares.get(i)))
                .toList());
  }

  /** Of a team that the nearest leads. */
  static Sentence ledByNearest(AllocationTask task, List<Member> team) {
    Member leader = team.getFirst();
    return Phrase.TOO_HEAVY_FOR_ONE.with(
        team.size(), shares(task, team), leader.robot().robot(), leader.approach());
  }

  /** The team is made of the least ones. */
  Comparator<Member> order(AllocationTask task);

  /** Of the team the least leads. */
  default Comparator<Member> leaderFirst(AllocationTask task) {
    return order(task);
  }

  /**
   * @param team the leader first
   * @return completes "Given to r1, r2: "
   */
  Sentence reason(AllocationTask task, List<Member> team);
}
