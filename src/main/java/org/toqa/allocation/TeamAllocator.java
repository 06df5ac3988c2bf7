package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.allocation.Costs.Cost;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Gives loads that are too heavy for every robot that fits on their path to several, and leaves the
 * rest to another allocator. The team is the smallest whose robots can each carry an even share; of
 * those that are free the ones nearest to the load, the nearest of all as the leader.
 *
 * <p>Robots seldom become free together. When such a load has waited longer than every other task,
 * robots that are free are kept for it, so that it does not wait for ever. Where it is fetched and
 * set down its robots are alone: {@link PlaceReservations}.
 */
public final class TeamAllocator implements Allocator {
  private static final int MOST_ROBOTS = 12;

  private final Allocator singleRobotAllocator;

  /**
   * @param singleRobotAllocator decides about loads that one robot can carry
   */
  public TeamAllocator(Allocator singleRobotAllocator) {
    this.singleRobotAllocator = singleRobotAllocator;
  }

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    Round round = new Round(problem);
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
    private final PlaceReservations places;
    private final List<Decision> decisions = new ArrayList<>();
    private final List<AllocationTask> singleRobotTasks = new ArrayList<>();
    private final Map<String, Long> taken = new HashMap<>();

    Round(AllocationProblem problem) {
      this.problem = problem;
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
      List<Candidate> nearest = team(task, usable, fitting(task), costs);
      int needed = size(task, fitting(task)).orElse(Integer.MAX_VALUE);
      if (nearest.size() == needed) {
        nearest.forEach(r -> taken.put(r.robot(), task.id()));
        places.reserve(task, true);
        decisions.add(assigned(task, nearest, costs));
        return;
      }
      if (singleRobotTasks.isEmpty() && needed <= MOST_ROBOTS) {
        nearest.forEach(r -> taken.put(r.robot(), task.id()));
        places.keepForWaiting(task, true);
      }
      decisions.add(explainer.unassigned(task));
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

  private record Priced(Candidate robot, Cost cost) {}

  /** The nearest of those that are free; fewer than are needed where not enough are. */
  private static List<Candidate> team(
      AllocationTask job, List<Candidate> free, List<Candidate> robots, Costs costs) {
    Optional<Integer> size = size(job, robots);
    if (size.isEmpty()) {
      return List.of();
    }
    AllocationTask share = share(job, size.get());
    return free.stream()
        .map(r -> new Priced(r, costs.of(share, r)))
        .filter(p -> p.cost().isPossible())
        .sorted(comparingDouble(p -> p.cost().approach()))
        .map(Priced::robot)
        .limit(size.get())
        .toList();
  }

  private static AllocationTask share(AllocationTask task, int robots) {
    return new AllocationTask(
        task.id(), task.load() / robots, task.start(), task.goal(), task.waitsFrom());
  }

  private static Decision assigned(AllocationTask task, List<Candidate> team, Costs costs) {
    double approach = costs.of(share(task, team.size()), team.getFirst()).approach();
    Sentence why =
        Phrase.TOO_HEAVY_FOR_ONE.with(
            team.size(), task.load() / team.size(), team.getFirst().robot(), approach);
    return new Decision.Assigned(task.id(), team.stream().map(Candidate::robot).toList(), why);
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
