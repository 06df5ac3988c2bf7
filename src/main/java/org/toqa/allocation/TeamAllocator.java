package org.toqa.allocation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.toqa.allocation.TeamRanking.Member;
import org.toqa.wording.Sentence;

/**
 * Gives loads that are too heavy for every robot that fits on their path to several, and leaves the
 * rest to another allocator. The team is the smallest whose robots can each carry an even share; of
 * those that are free the first ones of a {@link TeamRanking}, the first of all as the leader.
 *
 * <p>Robots seldom become free together. When such a load has waited longer than every other task,
 * robots that are free are kept for it, so that it does not wait for ever. Where it is fetched and
 * set down its robots are alone: {@link PlaceReservations}.
 */
public final class TeamAllocator implements Allocator {
  private static final int MOST_ROBOTS = 12;

  private final Allocator singleRobotAllocator;
  private final Function<AllocationProblem, TeamRanking> teamRanking;

  /**
   * @param singleRobotAllocator decides about loads that one robot can carry
   * @param teamRanking of a round's problem, who carries the others
   */
  TeamAllocator(
      Allocator singleRobotAllocator, Function<AllocationProblem, TeamRanking> teamRanking) {
    this.singleRobotAllocator = singleRobotAllocator;
    this.teamRanking = teamRanking;
  }

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    Round round = new Round(problem, teamRanking.apply(problem));
    problem.waiting().forEach(round::decide);
    List<AllocationTask> remaining = round.singleRobotTasks();
    round.decisions.addAll(
        singleRobotAllocator.allocate(withRemaining(problem, remaining, round.taken)));
    return round.decisions;
  }

  private static final class Round {
    private final AllocationProblem problem;
    private final WaitExplainer explainer;
    private final Costs costs;
    private final TeamRanking ranking;
    private final PlaceReservations places;
    private final List<Decision> decisions = new ArrayList<>();
    private final List<AllocationTask> singleRobotTasks = new ArrayList<>();
    private final Map<String, Long> taken = new HashMap<>();

    Round(AllocationProblem problem, TeamRanking ranking) {
      this.problem = problem;
      this.ranking = ranking;
      this.explainer = new WaitExplainer(problem);
      this.costs = new Costs(problem);
      this.places = new PlaceReservations(problem.placesInUse());
    }

    /** Decides about a task for several robots; in the order of precedence. */
    void decide(AllocationTask task) {
      List<Candidate> fitting = fitting(task);
      boolean together =
          !fitting.isEmpty() && fitting.stream().noneMatch(r -> r.isStrongEnough(task));
      if (addWaiting(task, places.conflict(task, together))) {
        places.keepForWaiting(task, together);
      } else if (together) {
        gatherTeam(task);
      } else {
        singleRobotTasks.add(task);
      }
    }

    /** The robots for which the path of the load is wide enough. */
    private List<Candidate> fitting(AllocationTask task) {
      return problem.robots().stream().filter(r -> costs.hasPathFor(task, r)).toList();
    }

    private boolean addWaiting(AllocationTask task, Optional<Sentence> objection) {
      objection.ifPresent(why -> decisions.add(new Decision.Unassigned(task.id(), why, List.of())));
      return objection.isPresent();
    }

    private void gatherTeam(AllocationTask task) {
      List<Candidate> usable =
          problem.freeRobots().stream().filter(r -> !taken.containsKey(r.robot())).toList();
      List<Member> team = team(task, usable, fitting(task));
      int needed = size(task, fitting(task)).orElse(Integer.MAX_VALUE);
      if (team.size() == needed) {
        team.forEach(m -> taken.put(m.robot().robot(), task.id()));
        places.reserve(task, true);
        decisions.add(assigned(task, team));
        return;
      }
      if (singleRobotTasks.isEmpty() && needed <= MOST_ROBOTS) {
        team.forEach(m -> taken.put(m.robot().robot(), task.id()));
        places.keepForWaiting(task, true);
      }
      decisions.add(explainer.unassigned(task));
    }

    /** The first of those that are free; fewer than are needed where not enough are. */
    private List<Member> team(AllocationTask task, List<Candidate> free, List<Candidate> robots) {
      Optional<Integer> size = size(task, robots);
      if (size.isEmpty()) {
        return List.of();
      }
      AllocationTask share = share(task, size.get());
      List<Member> able = new ArrayList<>();
      for (Candidate robot : free) {
        Costs.Cost cost = costs.of(share, robot);
        if (cost.isPossible()) {
          able.add(new Member(robot, cost.approach()));
        }
      }
      return able.stream().sorted(ranking.order(task)).limit(size.get()).toList();
    }

    private Decision assigned(AllocationTask task, List<Member> team) {
      List<String> robots = team.stream().map(m -> m.robot().robot()).toList();
      return new Decision.Assigned(task.id(), robots, ranking.reason(task, team));
    }

    /** The tasks for one robot each whose places no team has taken. */
    List<AllocationTask> singleRobotTasks() {
      return singleRobotTasks.stream()
          .filter(task -> !addWaiting(task, places.conflictWithUsers(task, false)))
          .toList();
    }
  }

  /** How many robots share the load evenly, of those that are not broken; empty if all cannot. */
  private static Optional<Integer> size(AllocationTask task, List<Candidate> robots) {
    return TeamSize.smallest(
        task.load(), robots.stream().filter(TeamAllocator::canBeFree).toList());
  }

  private static boolean canBeFree(Candidate robot) {
    return switch (robot.availability()) {
      case FREE, BUSY, CHARGING, HELD -> true;
      case CONNECTING, LOST, NOT_LOCALISED, ERROR, OUT_OF_SERVICE -> false;
    };
  }

  private static AllocationTask share(AllocationTask task, int robots) {
    return new AllocationTask(
        task.id(), task.load() / robots, task.start(), task.goal(), task.waitsFrom());
  }

  private static AllocationProblem withRemaining(
      AllocationProblem problem, List<AllocationTask> waiting, Map<String, Long> taken) {
    List<Candidate> robots =
        problem.robots().stream()
            .map(r -> taken.containsKey(r.robot()) ? r.withTask(taken.get(r.robot())) : r)
            .toList();
    return new AllocationProblem(
        problem.now(),
        problem.low(),
        problem.high(),
        problem.pathLengths(),
        problem.chargers(),
        waiting,
        problem.givenTasks(),
        robots,
        problem.placesInUse());
  }
}
