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
 * Gives loads that are too heavy for every robot that fits on their path to several, and leaves the
 * rest to another allocator. Of those that are free the team is the smallest whose maximum loads
 * add up: of these the first ones of a {@link TeamRanking}, the first of all as the leader. Each
 * has its {@linkplain TeamSize#shares share}.
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

  /**
   * @param kept robots that no task for one of them may have, since a load waits for more of them
   */
  record Outcome(List<Decision> decisions, Set<String> kept) {}

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    return decide(problem).decisions();
  }

  Outcome decide(AllocationProblem problem) {
    Round round = new Round(problem, teamRanking.apply(problem));
    problem.waiting().forEach(round::decide);
    List<AllocationTask> remaining = round.singleRobotTasks();
    round.decisions.addAll(
        singleRobotAllocator.allocate(withRemaining(problem, remaining, round.taken)));
    return new Outcome(round.decisions, Set.copyOf(round.kept));
  }

  /** Whether the load is too heavy for every robot that fits on its path. */
  static boolean isForSeveral(AllocationProblem problem, AllocationTask task) {
    return isForSeveral(task, fitting(problem, task));
  }

  private static boolean isForSeveral(AllocationTask task, List<Candidate> fitting) {
    return !fitting.isEmpty() && fitting.stream().noneMatch(r -> r.isStrongEnough(task));
  }

  /** The robots for which the path of the load is wide enough. */
  private static List<Candidate> fitting(AllocationProblem problem, AllocationTask task) {
    Quotes quotes = problem.quotes();
    return problem.robots().stream().filter(r -> quotes.hasPathFor(task, r)).toList();
  }

  private static final class Round {
    private final AllocationProblem problem;
    private final WaitExplainer explainer;
    private final Quotes quotes;
    private final TeamRanking ranking;
    private final PlaceReservations places;
    private final List<Decision> decisions = new ArrayList<>();
    private final List<AllocationTask> singleRobotTasks = new ArrayList<>();
    private final Map<String, Long> taken = new HashMap<>();
    private final Set<String> kept = new HashSet<>();

    Round(AllocationProblem problem, TeamRanking ranking) {
      this.problem = problem;
      this.ranking = ranking;
      this.explainer = new WaitExplainer(problem);
      this.quotes = problem.quotes();
      this.places = new PlaceReservations(problem.placesInUse());
    }

    /** Decides about a task for several robots; in the order of precedence. */
    void decide(AllocationTask task) {
      List<Candidate> fitting = fitting(problem, task);
      boolean together = isForSeveral(task, fitting);
      if (addWaiting(task, places.conflict(task, together))) {
        places.keepForWaiting(task, together);
      } else if (together) {
        gatherTeam(task, fitting);
      } else {
        singleRobotTasks.add(task);
      }
    }

    private boolean addWaiting(AllocationTask task, Optional<Sentence> objection) {
      objection.ifPresent(why -> decisions.add(new Decision.Unassigned(task.id(), why, List.of())));
      return objection.isPresent();
    }

    private void gatherTeam(AllocationTask task, List<Candidate> fitting) {
      List<Member> able = able(task);
      List<Candidate> free = able.stream().map(Member::robot).toList();
      Optional<Integer> size = TeamSize.smallest(task.load(), free);
      if (size.isPresent() && size.get() <= MOST_ROBOTS) {
        List<Candidate> team = TeamSize.first(task.load(), size.get(), free);
        team.forEach(robot -> taken.put(robot.robot(), task.id()));
        places.reserve(task, true);
        decisions.add(assigned(task, able.stream().filter(m -> team.contains(m.robot())).toList()));
        return;
      }
      int needed = size(task, fitting).orElse(Integer.MAX_VALUE);
      if (singleRobotTasks.isEmpty() && needed <= MOST_ROBOTS) {
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
        if (quote.isPossible() && !taken.containsKey(robot.robot())) {
          able.add(new Member(robot, quote.approach()));
        }
      }
      return able.stream().sorted(ranking.order(task)).toList();
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

  /** How many robots carry the load, of those that are not broken; empty if all cannot. */
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

  private static AllocationProblem withRemaining(
      AllocationProblem problem, List<AllocationTask> waiting, Map<String, Long> taken) {
    List<Candidate> robots =
        problem.robots().stream()
            .map(r -> taken.containsKey(r.robot()) ? r.withTask(taken.get(r.robot())) : r)
            .toList();
    return problem.withWaiting(waiting, robots);
  }
}
