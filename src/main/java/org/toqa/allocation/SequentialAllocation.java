package org.toqa.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.toqa.wording.Sentence;

/** Serves one task after the other, the one that has waited longest first. */
final class SequentialAllocation {
  private SequentialAllocation() {}

  /** Who carries a task, of the robots that are left. */
  @FunctionalInterface
  interface RobotChooser {
    Optional<Chosen> choose(AllocationTask task, List<Candidate> left);
  }

  /**
   * @param reason completes "Given to r1: "
   */
  record Chosen(Candidate robot, Sentence reason) {}

  static List<Decision> allocate(AllocationProblem situation, RobotChooser choice) {
    WaitExplainer explainer = new WaitExplainer(situation);
    List<Candidate> left = new ArrayList<>(situation.freeRobots());
    List<Decision> decisions = new ArrayList<>();
    for (AllocationTask job : situation.waiting()) {
      Optional<Chosen> chosen = choice.choose(job, List.copyOf(left));
      if (chosen.isPresent()) {
        Candidate robot = chosen.get().robot();
        left.remove(robot);
        decisions.add(
            new Decision.Assigned(job.id(), List.of(robot.robot()), chosen.get().reason()));
      } else {
        decisions.add(explainer.unassigned(job));
      }
    }
    return decisions;
  }
}
