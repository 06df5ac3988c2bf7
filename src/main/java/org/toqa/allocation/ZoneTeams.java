package org.toqa.allocation;

import static java.util.Comparator.comparingInt;

import java.util.Comparator;
import java.util.List;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The robots of the load's zone, of those beside it, and so on outward (Tanta, "Load-based
 * allocation"). It looks at no distance but that of the zones.
 */
final class ZoneTeams implements TeamRanking {
  private final Zones zones;

  ZoneTeams(AllocationProblem problem) {
    zones = new Zones(problem.low(), problem.high(), problem.robots());
  }

  @Override
  public Comparator<Member> order(AllocationTask task) {
    List<Candidate> outward = zones.outwardFrom(task.start()).stream().map(zones::robotOf).toList();
    return comparingInt(member -> outward.indexOf(member.robot()));
  }

  @Override
  public Sentence reason(AllocationTask task, List<Member> team) {
    Candidate leader = team.getFirst().robot();
    return Phrase.TEAM_FROM_ZONES.with(
        team.size(),
        TeamRanking.shares(task, team),
        leader.robot(),
        zones.zoneOfRobot(leader) + 1,
        zones.zoneOf(task.start()) + 1,
        zones.count());
  }
}
