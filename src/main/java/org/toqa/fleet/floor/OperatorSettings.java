package org.toqa.fleet.floor;

import org.toqa.fleet.PendingResume;

/** What people have said of a robot. Only {@link OperatorCommandHandler} changes it. */
final class OperatorSettings {
  private boolean inService;
  private boolean held;

  /** Of the robot itself. */
  final PendingResume resume = new PendingResume();

  OperatorSettings(boolean inService, boolean held) {
    this.inService = inService;
    this.held = held;
  }

  boolean isInService() {
    return inService;
  }

  /** Whether a person has put the robot itself on hold. */
  boolean isHeld() {
    return held;
  }

  void setInService(boolean isIn) {
    inService = isIn;
  }

  void setHeld(boolean hold) {
    held = hold;
  }
}
