package org.toqa.allocation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.toqa.allocation.RoundTable.Filling;
import org.toqa.allocation.TeamRanking.Member;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * As many robots at work as can be, at the least total cost over all free robots and all tasks at
 * once, loads for several robots among them: a {@link JointAssignment}. Where tasks outnumber
 * robots, the time that a task has waited lowers its cost, so that some day it comes before any
 * newcomer. Tasks whose loads are not picked up are dealt out anew with the others, and go to
 * another robot where that is worth a robot's turning round.
 */
public final class OptimalAllocator implements Allocator {
  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    return new Round(problem).decide();
  }

  private static final class Round {
    private final AllocationProblem problem;
    private final OpenTasks open;
    private final RoundTable table;
    private final Filling filling;
    private final List<Decision> decisions;

    Round(AllocationProblem problem) {
      this.problem = problem;
      open = new OpenTasks(problem);
      table = new RoundTable(problem, open);
      filling = new JointAssignment(table, open).best();
      decisions = new ArrayList<>(open.waiting());
    }

    List<Decision> decide() {
      for (int task = 0; task < table.taskCount(); task++) {
        List<Integer> members = filling.robots().get(task);
        if (members.size() > 1) {
          giveToTeam(task, members);
        } else if (!members.isEmpty()) {
          give(task, members.getFirst());
        }
      }
      WaitExplainer explainer = new WaitExplainer(problem.robotsAfter(decisions), problem.quotes());
      for (int task = 0; task < table.taskCount(); task++) {
        if (filling.robots().get(task).isEmpty() && table.holder(task).isEmpty()) {
          decisions.add(unassigned(task, explainer));
        }
      }
      return decisions;
    }

    private void give(int task, int robot) {
      Optional<String> holder = table.holder(task);
      Candidate chosen = table.robot(robot);
      if (!holder.equals(Optional.of(chosen.robot()))) {
        Phrase phrase =
            table.task(task).isDrive() ? Phrase.LEAST_ENERGY_FOR_DRIVE : Phrase.LEAST_ENERGY;
        Sentence least =
            phrase.with(
                table.quote(task, robot).approach(),
                problem.waiting().size(),
                problem.freeRobots().size());
        Sentence why = holder.map(from -> Phrase.TAKEN_OVER.with(least, from)).orElse(least);
        decisions.add(new Decision.Assigned(table.task(task).id(), List.of(chosen.robot()), why));
      }
    }

    /** The nearest leads. */
    private void giveToTeam(int task, List<Integer> members) {
      List<Member> team =
          members.stream()
              .map(robot -> new Member(table.robot(robot), table.quote(task, robot)))
              .sorted(Comparator.comparingDouble(Member::approach))
              .toList();
      open.places().reserve(table.task(task), true);
      decisions.add(
          new Decision.Assigned(
              table.task(task).id(),
              team.stream().map(member -> member.robot().robot()).toList(),
              TeamRanking.ledByNearest(table.task(task), team)));
    }

    private Decision unassigned(int number, WaitExplainer explainer) {
      AllocationTask task = table.task(number);
      return open.places()
          .conflictWithUsers(task, number >= table.firstTeam())
          .<Decision>map(why -> new Decision.Unassigned(task.id(), why, List.of()))
          .orElseGet(() -> explainer.unassigned(task));
    }
  }
}
