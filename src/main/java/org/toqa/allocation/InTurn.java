package org.toqa.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.toqa.wording.Sentence;

/** Serves one task after the other, the one that has waited longest first. */
final class InTurn {
  private InTurn() {}

  /** Who carries a task, of the robots that are left. */
  @FunctionalInterface
  interface Choice {
    Optional<Chosen> choose(Job job, List<Candidate> left);
  }

  /**
   * @param why completes "Given to r1: "
   */
  record Chosen(Candidate robot, Sentence why) {}

  static List<Decision> decide(Situation situation, Choice choice) {
    WaitingReason reason = new WaitingReason(situation);
    List<Candidate> left = new ArrayList<>(situation.free());
    List<Decision> decisions = new ArrayList<>();
    for (Job job : situation.waiting()) {
      Optional<Chosen> chosen = choice.choose(job, List.copyOf(left));
      if (chosen.isPresent()) {
        Candidate robot = chosen.get().robot();
        left.remove(robot);
        decisions.add(new Decision.Assigned(job.id(), List.of(robot.robot()), chosen.get().why()));
      } else {
        decisions.add(reason.waits(job));
      }
    }
    return decisions;
  }
}
