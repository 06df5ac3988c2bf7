package org.toqa.allocation;

import static java.util.stream.Collectors.toSet;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.toqa.allocation.AllocationProblem.GivenTask;
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
  private static final double METRES_PER_SECOND_WAITED = 0.1;

  /** A robot is not turned round for less, metres. */
  private static final double TURN_ROUND_METRES = 2;

  /** Above any sum of real costs: pairs that cannot be, and tasks that must not be dropped. */
  private static final double FORBIDDEN = 1e12;

  private static final double MUST = 1e9;

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    Table table = new Table(problem);
    Candidate[] chosen = table.assign();
    WaitExplainer explainer = new WaitExplainer(problem);
    List<Decision> decisions = new ArrayList<>();
    for (int j = 0; j < table.tasks.size(); j++) {
      AllocationTask task = table.tasks.get(j);
      Optional<String> holder = table.holder(j);
      Candidate robot = chosen[j];
      if (robot != null && !holder.equals(Optional.of(robot.robot()))) {
        decisions.add(
            new Decision.Assigned(task.id(), List.of(robot.robot()), table.reason(j, robot)));
      } else if (robot == null && holder.isEmpty()) {
        decisions.add(explainer.unassigned(task));
      }
    }
    return decisions;
  }

  /** The tasks given out and the waiting ones, against the robots that can have one of them. */
  private static final class Table {
    private final AllocationProblem problem;
    private final List<AllocationTask> tasks;
    private final List<Candidate> robots;
    private final List<List<Quote>> costs;

    Table(AllocationProblem problem) {
      this.problem = problem;
      Set<String> holders = problem.givenTasks().stream().map(GivenTask::robot).collect(toSet());
      tasks =
          Stream.concat(
                  problem.givenTasks().stream().map(GivenTask::task), problem.waiting().stream())
              .toList();
      robots =
          problem.robots().stream().filter(r -> r.isFree() || holders.contains(r.robot())).toList();
      Quotes model = problem.quotes();
      costs = tasks.stream().map(task -> model.of(task, robots)).toList();
    }

    /** The robot that has the task now. */
    Optional<String> holder(int task) {
      return task < problem.givenTasks().size()
          ? Optional.of(problem.givenTasks().get(task).robot())
          : Optional.empty();
    }

    /** By job; null for a job that gets none. */
    @SuppressWarnings("NullAway") // an array's elements
    Candidate[] assign() {
      boolean jobsAreRows = tasks.size() <= robots.size();
      int rows = jobsAreRows ? tasks.size() : robots.size();
      int columns = jobsAreRows ? robots.size() : tasks.size();
      double[] flat = new double[rows * columns];
      for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
          flat[row * columns + column] = jobsAreRows ? weight(row, column) : weight(column, row);
        }
      }
      int[] columnOf = Assignment.leastCost(flat, rows);
      Candidate[] chosen = new Candidate[tasks.size()];
      for (int row = 0; row < rows; row++) {
        int task = jobsAreRows ? row : columnOf[row];
        int robot = jobsAreRows ? columnOf[row] : row;
        if (costs.get(task).get(robot).isPossible() || isHolder(robot, task)) {
          chosen[task] = robots.get(robot);
        }
      }
      return chosen;
    }

    private double weight(int task, int robot) {
      Quote cost = costs.get(task).get(robot);
      if (!cost.isPossible()) {
        return isHolder(robot, task)
            ? 0
            : FORBIDDEN; // who has it keeps it, unless another can do it
      }
      if (holder(task).isPresent()) {
        double detour = isHolder(robot, task) ? 0 : Energy.joules(TURN_ROUND_METRES, 0);
        return cost.joules() + detour - MUST;
      }
      double waited = tasks.get(task).waitedSeconds(problem.now()) * METRES_PER_SECOND_WAITED;
      return cost.joules() - Energy.joules(waited, 0);
    }

    private boolean isHolder(int robot, int task) {
      return holder(task).equals(Optional.of(robots.get(robot).robot()));
    }

    Sentence reason(int task, Candidate robot) {
      Sentence least =
          Phrase.LEAST_ENERGY.with(
              costs.get(task).get(robots.indexOf(robot)).approach(),
              problem.waiting().size(),
              problem.freeRobots().size());
      return holder(task).map(from -> Phrase.TAKEN_OVER.with(least, from)).orElse(least);
    }
  }
}
