package org.toqa.allocation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.toqa.allocation.TeamRanking.Member;
import org.toqa.wording.Sentence;

/**
 * Serves one task after the other, the one that has waited longest first. Loads that are too heavy
 * for every robot that fits on their path go to several, the rest is left to another allocator. Of
 * those that are free the team is the smallest whose maximum loads add up: of these the first ones
 * of a {@link TeamRanking}. Each has its {@linkplain TeamSize#shares share}.
 *
 * <p>Robots seldom become free together. When such a load has waited longer than every other task
 * that waits, robots that are free are kept for it, so that it does not wait for ever. Where it is
 * fetched and set down its robots are alone: {@link PlaceReservations}.
 */
public final class TeamAllocator implements Allocator {
  private final Allocator singleRobotAllocator;
  private final Function<AllocationProblem, TeamRanking> teamRanking;

  /**
   * @param singleRobotAllocator decides about loads that one robot can carry, one at a time
   * @param teamRanking of a round's problem, who carries the others
   */
  TeamAllocator(
      Allocator singleRobotAllocator, Function<AllocationProblem, TeamRanking> teamRanking) {
    this.singleRobotAllocator = singleRobotAllocator;
    this.teamRanking = teamRanking;
  }

  /**
   * @param kept robots that no task for one of them may have, since a load waits for more of them
   */
  record Outcome(List<Decision> decisions, Set<String> kept) {}

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    return decide(problem).decisions();
  }

  Outcome decide(AllocationProblem problem) {
    Round round = new Round(problem);
    problem.waiting().forEach(round::decide);
    return new Outcome(round.decisions, Set.copyOf(round.kept));
  }

  private final class Round {
    private final AllocationProblem problem;
    private final WaitExplainer explainer;
    private final Quotes quotes;
    private final TeamRanking ranking;
    private final PlaceReservations places;
    private final List<Decision> decisions = new ArrayList<>();
    private final Map<String, Long> taken = new HashMap<>();
    private final Set<String> kept = new HashSet<>();

    /** Whether a task for one robot waits that came before. */
    private boolean isAnyWaiting;

    Round(AllocationProblem problem) {
      this.problem = problem;
      this.ranking = teamRanking.apply(problem);
      this.explainer = new WaitExplainer(problem);
      this.quotes = problem.quotes();
      this.places = new PlaceReservations(problem.placesInUse());
    }

    /** Decides about a task; in the order of precedence. */
    void decide(AllocationTask task) {
      List<Candidate> fitting = TeamSize.fitting(problem, task);
      boolean together = TeamSize.isForSeveral(task, fitting);
      Optional<Sentence> conflict = places.conflict(task, together);
      if (conflict.isPresent()) {
        decisions.add(new Decision.Unassigned(task.id(), conflict.get(), List.of()));
        places.keepForWaiting(task, together);
      } else if (together) {
        gatherTeam(task, fitting);
      } else {
        giveToOne(task);
      }
    }

    private void giveToOne(AllocationTask task) {
      Decision decision =
          singleRobotAllocator.allocate(problem.withWaiting(List.of(task), left())).getFirst();
      decisions.add(decision);
      switch (decision) {
        case Decision.Assigned assigned -> {
          assigned.robots().forEach(robot -> taken.put(robot, task.id()));
          places.reserve(task, false);
        }
        case Decision.Unassigned _ -> isAnyWaiting = true;
      }
    }

    private List<Candidate> left() {
      return problem.robots().stream()
          .map(r -> taken.containsKey(r.robot()) ? r.withTask(taken.get(r.robot())) : r)
          .toList();
    }

    private void gatherTeam(AllocationTask task, List<Candidate> fitting) {
      List<Member> able = able(task);
      List<Candidate> free = able.stream().map(Member::robot).toList();
      Optional<Integer> size = TeamSize.smallest(task.load(), free);
      if (size.isPresent() && size.get() <= OpenTasks.MOST_ROBOTS) {
        List<Candidate> team = TeamSize.first(task.load(), size.get(), free);
        team.forEach(robot -> taken.put(robot.robot(), task.id()));
        places.reserve(task, true);
        decisions.add(
            assigned(
                task,
                able.stream()
                    .filter(m -> team.contains(m.robot()))
                    .sorted(ranking.leaderFirst(task))
                    .toList()));
        return;
      }
      int needed = TeamSize.ofAll(task, fitting).orElse(Integer.MAX_VALUE);
      if (!isAnyWaiting && needed <= OpenTasks.MOST_ROBOTS) {
        free.stream()
            .limit(needed)
            .map(Candidate::robot)
            .forEach(
                robot -> {
                  taken.put(robot, task.id());
                  kept.add(robot);
                });
        places.keepForWaiting(task, true);
      }
      decisions.add(explainer.unassigned(task));
    }

    /** Those that are free and can carry a part, the first ones for it first. */
    private List<Member> able(AllocationTask task) {
      List<Member> able = new ArrayList<>();
      for (Candidate robot : problem.freeRobots()) {
        Quote quote = quotes.of(task.partFor(robot), robot);
        if (task.allowsInTeam(robot) && quote.isPossible() && !taken.containsKey(robot.robot())) {
          able.add(new Member(robot, quote));
        }
      }
      return able.stream().sorted(ranking.order(task)).toList();
    }

    private Decision assigned(AllocationTask task, List<Member> team) {
      List<String> robots = team.stream().map(m -> m.robot().robot()).toList();
      return new Decision.Assigned(task.id(), robots, ranking.reason(task, team));
    }
  }
}
