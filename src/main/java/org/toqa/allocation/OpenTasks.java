package org.toqa.allocation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.toqa.wording.Sentence;

/**
 * Of the tasks that wait, those that may be given out in a round, and why the others wait. A load
 * that is too heavy for every robot that fits on its path is for a team, the smallest whose maximum
 * loads add up.
 *
 * <p>Robots are kept for a load that has waited longest as by {@link TeamAllocator}; when they are
 * enough, it goes before the others. Confined to one round.
 */
final class OpenTasks {
  static final int MOST_ROBOTS = 12;

  private final AllocationProblem problem;
  private final Quotes quotes;
  private final WaitExplainer explainer;
  private final PlaceReservations places;
  private final List<AllocationTask> singles = new ArrayList<>();
  private final List<TeamTask> teams = new ArrayList<>();
  private final List<Decision> waiting = new ArrayList<>();
  private final Set<String> kept = new HashSet<>();

  /** Whether the first team's task has waited longer than every task for one robot. */
  private boolean isFirstTeamOldest;

  /**
   * A load for several robots.
   *
   * @param size how many, as few as can be
   * @param able robots that are free and can carry a part
   * @param quotes of each of them, for its part
   */
  record TeamTask(AllocationTask task, int size, List<Candidate> able, List<Quote> quotes) {}

  OpenTasks(AllocationProblem problem) {
    this.problem = problem;
    this.quotes = problem.quotes();
    this.explainer = new WaitExplainer(problem);
    this.places = new PlaceReservations(problem.placesInUse());
    problem.waiting().forEach(this::sort);
  }

  /** In the order of precedence, as the others. */
  List<AllocationTask> singles() {
    return singles;
  }

  List<TeamTask> teams() {
    return teams;
  }

  /** Those of the tasks that wait in any case. */
  List<Decision> waiting() {
    return waiting;
  }

  boolean isFirstTeamOldest() {
    return isFirstTeamOldest;
  }

  /** Robots that no task may have, since a load waits for more of them. */
  Set<String> kept() {
    return kept;
  }

  PlaceReservations places() {
    return places;
  }

  private void sort(AllocationTask task) {
    List<Candidate> fitting = TeamSize.fitting(problem, task);
    boolean together = TeamSize.isForSeveral(task, fitting);
    Optional<Sentence> conflict = places.conflict(task, together);
    if (conflict.isPresent()) {
      waiting.add(new Decision.Unassigned(task.id(), conflict.get(), List.of()));
      places.keepForWaiting(task, together);
    } else if (together) {
      addTeam(task, fitting);
    } else {
      singles.add(task);
    }
  }

  private void addTeam(AllocationTask task, List<Candidate> fitting) {
    List<Candidate> able = new ArrayList<>();
    List<Quote> parts = new ArrayList<>();
    for (Candidate robot : problem.freeRobots()) {
      Quote quote = quotes.of(task.partFor(robot), robot);
      if (task.allowsInTeam(robot) && quote.isPossible() && !kept.contains(robot.robot())) {
        able.add(robot);
        parts.add(quote);
      }
    }
    Optional<Integer> size = TeamSize.smallest(task.load(), able);
    if (size.isPresent() && size.get() <= MOST_ROBOTS) {
      isFirstTeamOldest |= teams.isEmpty() && singles.isEmpty();
      teams.add(new TeamTask(task, size.get(), able, parts));
      return;
    }
    int needed = TeamSize.ofAll(task, fitting).orElse(Integer.MAX_VALUE);
    if (singles.isEmpty() && teams.isEmpty() && needed <= MOST_ROBOTS) {
      able.stream().limit(needed).map(Candidate::robot).forEach(kept::add);
      places.keepForWaiting(task, true);
    }
    waiting.add(explainer.unassigned(task));
  }
}
