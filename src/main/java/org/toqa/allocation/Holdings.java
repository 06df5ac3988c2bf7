package org.toqa.allocation;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.toqa.wording.Sentence;

/** Who has which task as a negotiation goes on. */
final class Holdings {
  private final AllocationProblem problem;
  private final ReceivedQuotes quotes;
  private final Map<Long, AllocationTask> tasks = new TreeMap<>();

  /** By task, who has it, a team's leader first. */
  private final Map<Long, List<String>> holders = new TreeMap<>();

  /** By task that went to somebody, why. */
  private final Map<Long, Sentence> reasons = new HashMap<>();

  /** By task, what was decided last while nobody had it. */
  private final Map<Long, Decision> undecided = new HashMap<>();

  Holdings(AllocationProblem problem, ReceivedQuotes quotes) {
    this.problem = problem;
    this.quotes = quotes;
    problem.waiting().forEach(task -> tasks.put(task.id(), task));
    for (AllocationProblem.GivenTask given : problem.givenTasks()) {
      tasks.put(given.task().id(), given.task());
      holders.put(given.task().id(), List.of(given.robot()));
    }
  }

  AllocationTask task(long id) {
    return requireNonNull(tasks.get(id));
  }

  void give(long task, List<String> robots, Sentence why) {
    holders.put(task, robots);
    reasons.put(task, why);
  }

  void setUndecided(Decision decision) {
    undecided.put(decision.task(), decision);
  }

  /** The leader of those who have the task. */
  String holder(long task) {
    return requireNonNull(holders.get(task)).getFirst();
  }

  /** By task that one robot has and has not begun, that robot. */
  Map<Long, String> tradable() {
    Map<Long, String> tradable = new TreeMap<>();
    holders.forEach(
        (task, team) -> {
          if (team.size() == 1) {
            tradable.put(task, team.getFirst());
          }
        });
    return tradable;
  }

  Set<String> engagedRobots() {
    Set<String> engaged = new TreeSet<>();
    holders.values().forEach(engaged::addAll);
    return engaged;
  }

  /** What nobody has, and every robot as it is now. */
  AllocationProblem open() {
    List<PlaceUse> uses =
        Stream.concat(
                problem.placesInUse().stream(),
                problem.waiting().stream()
                    .filter(task -> holders.containsKey(task.id()))
                    .flatMap(task -> PlaceUse.of(task, isForSeveral(task)).stream()))
            .toList();
    return new AllocationProblem(
        problem.now(),
        problem.low(),
        problem.high(),
        problem.terrain(),
        problem.waiting().stream().filter(task -> !holders.containsKey(task.id())).toList(),
        List.of(),
        robotsNow(),
        uses,
        quotes);
  }

  private List<Candidate> robotsNow() {
    Map<String, Long> engaged = new HashMap<>();
    holders.forEach((task, team) -> team.forEach(robot -> engaged.put(robot, task)));
    Set<String> givers = new TreeSet<>();
    problem.givenTasks().forEach(given -> givers.add(given.robot()));
    return problem.robots().stream().map(robot -> now(robot, engaged, givers)).toList();
  }

  private static Candidate now(Candidate robot, Map<String, Long> engaged, Set<String> givers) {
    Long task = engaged.get(robot.robot());
    if (task != null) {
      return robot.withTask(task);
    }
    return givers.contains(robot.robot()) ? robot.withoutTask() : robot;
  }

  private boolean isForSeveral(AllocationTask task) {
    return holders.getOrDefault(task.id(), List.of()).size() > 1;
  }

  /** What is decided of each task that waited, and of those that have changed robots. */
  List<Decision> decisions() {
    List<Decision> decisions = new ArrayList<>();
    for (AllocationTask task : problem.waiting()) {
      List<String> team = holders.get(task.id());
      decisions.add(
          team == null ? requireNonNull(undecided.get(task.id())) : assigned(task.id(), team));
    }
    for (AllocationProblem.GivenTask given : problem.givenTasks()) {
      String holder = holder(given.task().id());
      if (!holder.equals(given.robot())) {
        decisions.add(assigned(given.task().id(), List.of(holder)));
      }
    }
    return decisions;
  }

  private Decision assigned(long task, List<String> robots) {
    return new Decision.Assigned(task, robots, requireNonNull(reasons.get(task)));
  }
}
