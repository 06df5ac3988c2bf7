package org.toqa.allocation;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.wording.Sentence;

/** Who has what after a round, and what that costs. */
final class Outcome {
  private final AllocationProblem situation;

  /** By task. */
  final Map<Long, String> holders = new TreeMap<>();

  Outcome(AllocationProblem situation, List<Decision> decisions) {
    this.situation = situation;
    for (GivenTask given : situation.givenTasks()) {
      holders.put(given.task().id(), given.robot());
    }
    decisions.forEach(d -> robots(d).forEach(name -> holders.put(d.task(), name)));
  }

  /** The decisions, with their reasons as they read in English. */
  static List<Decision> inEnglish(List<Decision> decisions) {
    return decisions.stream().map(Outcome::inEnglish).toList();
  }

  private static Decision inEnglish(Decision decision) {
    Sentence why = Sentence.verbatim(decision.reason().english());
    return switch (decision) {
      case Decision.Assigned d -> new Decision.Assigned(d.task(), d.robots(), why);
      case Decision.Unassigned d -> new Decision.Unassigned(d.task(), why, d.drained());
    };
  }

  static List<String> robots(Decision decision) {
    return decision instanceof Decision.Assigned assigned ? assigned.robots() : List.of();
  }

  double joules() {
    Map<String, Candidate> robots = new HashMap<>();
    situation.robots().forEach(r -> robots.put(r.robot(), r));
    Map<Long, AllocationTask> jobs = new HashMap<>();
    situation.waiting().forEach(j -> jobs.put(j.id(), j));
    situation.givenTasks().forEach(g -> jobs.put(g.task().id(), g.task()));
    Costs costs = new Costs(situation.terrain());
    double sum = 0;
    for (Map.Entry<Long, String> entry : holders.entrySet()) {
      AllocationTask task = requireNonNull(jobs.get(entry.getKey()));
      Candidate robot = requireNonNull(robots.get(entry.getValue()));
      sum += costs.of(task, robot).joules();
    }
    return sum;
  }
}
