package org.toqa.arm;

import java.util.List;

/** What an arm does for a task, step by step. */
public enum ArmAction {
  /** The hand goes to the load, grasps it, weighs it, and brings it to its rest. */
  PICK,
  /** The hand brings the load to its place, lets it go, and comes back to its rest. */
  PLACE;

  /** In their order. */
  public List<ArmStep> steps() {
    return switch (this) {
      case PICK -> List.of(ArmStep.REACH, ArmStep.GRASP, ArmStep.WEIGH, ArmStep.FOLD);
      case PLACE -> List.of(ArmStep.REACH, ArmStep.RELEASE, ArmStep.FOLD);
    };
  }
}
