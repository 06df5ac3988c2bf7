package org.toqa.allocation;

import static java.util.stream.Collectors.toSet;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.toqa.allocation.Costs.Cost;
import org.toqa.allocation.Situation.Given;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * As many tasks as there are robots for them, at the least total cost over all free robots and all
 * tasks at once: an {@link Assignment}. Where tasks outnumber robots, the time that a task has
 * waited lowers its cost, so that some day it comes before any newcomer. Tasks whose loads are not
 * picked up are dealt out anew with the others, and go to another robot where that is worth a
 * robot's turning round.
 */
public final class OptimalAllocator implements Allocator {
  /** A second that a task has waited longer is worth this detour, metres. */
  private static final double METRES_A_SECOND = 0.1;

  /** A robot is not turned round for less, metres. */
  private static final double TURNING_ROUND = 2;

  /** Above any sum of real costs: pairs that cannot be, and tasks that must not be dropped. */
  private static final double FORBIDDEN = 1e12;

  private static final double MUST = 1e9;

  @Override
  public List<Decision> allocate(Situation situation) {
    Table table = new Table(situation);
    Candidate[] chosen = table.deal();
    WaitingReason reason = new WaitingReason(situation);
    List<Decision> decisions = new ArrayList<>();
    for (int j = 0; j < table.jobs.size(); j++) {
      Job job = table.jobs.get(j);
      Optional<String> holder = table.holder(j);
      Candidate robot = chosen[j];
      if (robot != null && !holder.equals(Optional.of(robot.robot()))) {
        decisions.add(new Decision.Assigned(job.id(), List.of(robot.robot()), table.why(j, robot)));
      } else if (robot == null && holder.isEmpty()) {
        decisions.add(reason.waits(job));
      }
    }
    return decisions;
  }

  /** The tasks given out and the waiting ones, against the robots that can have one of them. */
  private static final class Table {
    private final Situation situation;
    private final List<Job> jobs;
    private final List<Candidate> robots;
    private final List<List<Cost>> costs;

    Table(Situation situation) {
      this.situation = situation;
      Set<String> holders = situation.given().stream().map(Given::robot).collect(toSet());
      jobs =
          Stream.concat(situation.given().stream().map(Given::job), situation.waiting().stream())
              .toList();
      robots =
          situation.robots().stream()
              .filter(r -> r.isFree() || holders.contains(r.robot()))
              .toList();
      Costs model = new Costs(situation);
      costs = jobs.stream().map(job -> model.of(job, robots)).toList();
    }

    /** The robot that has the task now. */
    Optional<String> holder(int job) {
      return job < situation.given().size()
          ? Optional.of(situation.given().get(job).robot())
          : Optional.empty();
    }

    /** By job; null for a job that gets none. */
    @SuppressWarnings("NullAway") // an array's elements
    Candidate[] deal() {
      boolean jobsAreRows = jobs.size() <= robots.size();
      int rows = jobsAreRows ? jobs.size() : robots.size();
      int columns = jobsAreRows ? robots.size() : jobs.size();
      double[] flat = new double[rows * columns];
      for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
          flat[row * columns + column] = jobsAreRows ? weight(row, column) : weight(column, row);
        }
      }
      int[] columnOf = Assignment.leastCost(flat, rows);
      Candidate[] chosen = new Candidate[jobs.size()];
      for (int row = 0; row < rows; row++) {
        int job = jobsAreRows ? row : columnOf[row];
        int robot = jobsAreRows ? columnOf[row] : row;
        if (costs.get(job).get(robot).isPossible() || holds(robot, job)) {
          chosen[job] = robots.get(robot);
        }
      }
      return chosen;
    }

    private double weight(int job, int robot) {
      Cost cost = costs.get(job).get(robot);
      if (!cost.isPossible()) {
        return holds(robot, job) ? 0 : FORBIDDEN; // who has it keeps it, unless another can do it
      }
      if (holder(job).isPresent()) {
        double detour = holds(robot, job) ? 0 : Energy.joules(TURNING_ROUND, 0);
        return cost.joules() + detour - MUST;
      }
      double waited = jobs.get(job).waited(situation.now()) * METRES_A_SECOND;
      return cost.joules() - Energy.joules(waited, 0);
    }

    private boolean holds(int robot, int job) {
      return holder(job).equals(Optional.of(robots.get(robot).robot()));
    }

    Sentence why(int job, Candidate robot) {
      Sentence least =
          Phrase.LEAST_ENERGY.with(
              costs.get(job).get(robots.indexOf(robot)).approach(),
              situation.waiting().size(),
              situation.free().size());
      return holder(job).map(from -> Phrase.TAKEN_OVER.with(least, from)).orElse(least);
    }
  }
}
