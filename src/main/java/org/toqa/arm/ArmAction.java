package org.toqa.arm;

import java.util.List;

/** What an arm does for a task, step by step. */
public enum ArmAction {
  /** The hand goes to the load, grasps it, weighs it, and brings it to its rest. */
  PICK(List.of(ArmStep.REACH, ArmStep.GRASP, ArmStep.WEIGH, ArmStep.FOLD)),
  /** The hand brings the load to its place, lets it go, and comes back to its rest. */
  PLACE(List.of(ArmStep.REACH, ArmStep.RELEASE, ArmStep.FOLD));

  @SuppressWarnings("ImmutableEnumChecker") // a list that cannot be changed
  private final List<ArmStep> steps;

  ArmAction(List<ArmStep> steps) {
    this.steps = steps;
  }

  /** In their order. */
  public List<ArmStep> steps() {
    return steps;
  }
}
