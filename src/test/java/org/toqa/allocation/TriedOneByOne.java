package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** All ways to give out the tasks of a small round, for what {@link OptimalAllocator} answers. */
final class TriedOneByOne {
  private final AllocationProblem problem;
  private final Costs costs;
  private int mostWorking;
  private double leastJoules;

  TriedOneByOne(AllocationProblem problem) {
    this.problem = problem;
    this.costs = new Costs(problem.terrain());
  }

  /** Whether no task goes before the others, or has robots kept for it, whatever it costs. */
  boolean isWithoutPrecedence() {
    return problem.waiting().stream().noneMatch(task -> TeamSize.isForSeveral(problem, task))
        || !TeamSize.isForSeveral(problem, problem.waiting().getFirst());
  }

  void assertNoneIsBetterThan(List<Decision> decisions, String where) {
    mostWorking = 0;
    leastJoules = 0;
    tryAll(0, new HashSet<>(), 0);
    int working = 0;
    double joules = 0;
    for (Decision decision : decisions) {
      AllocationTask task =
          problem.waiting().stream()
              .filter(t -> t.id() == decision.task())
              .findFirst()
              .orElseThrow();
      for (String name : Outcome.robots(decision)) {
        Candidate robot =
            problem.robots().stream().filter(r -> r.robot().equals(name)).findFirst().orElseThrow();
        working++;
        joules += joules(task, robot, Outcome.robots(decision).size() > 1);
      }
    }
    assertEquals(mostWorking, working, where);
    assertTrue(joules <= leastJoules + 1e-3, where + ": " + joules + " J, not " + leastJoules);
  }

  private void tryAll(int index, Set<Candidate> taken, double joules) {
    if (index == problem.waiting().size()) {
      if (taken.size() > mostWorking || (taken.size() == mostWorking && joules < leastJoules)) {
        mostWorking = taken.size();
        leastJoules = joules;
      }
      return;
    }
    AllocationTask task = problem.waiting().get(index);
    tryAll(index + 1, taken, joules);
    boolean together = TeamSize.isForSeveral(problem, task);
    List<Candidate> able =
        problem.freeRobots().stream()
            .filter(r -> costs.of(together ? task.partFor(r) : task, r).isPossible())
            .toList();
    int size = together ? TeamSize.smallest(task.load(), able).orElse(Integer.MAX_VALUE) : 1;
    for (int set = 1; set < 1 << able.size(); set++) {
      if (Integer.bitCount(set) != size) {
        continue;
      }
      int members = set;
      List<Candidate> team =
          able.stream().filter(r -> (members >> able.indexOf(r) & 1) == 1).toList();
      if (team.stream().noneMatch(taken::contains) && TeamSize.isStrongEnough(task.load(), team)) {
        double more = team.stream().mapToDouble(r -> joules(task, r, together)).sum();
        taken.addAll(team);
        tryAll(index + 1, taken, joules + more);
        team.forEach(taken::remove);
      }
    }
  }

  /** Less what it is worth that it has waited: 0.1 m a second. */
  private double joules(AllocationTask task, Candidate robot, boolean together) {
    double waited = task.waitedSeconds(problem.now()) * 0.1;
    return costs.of(together ? task.partFor(robot) : task, robot).joules()
        - Energy.joules(waited, 0);
  }
}
