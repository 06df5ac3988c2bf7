package org.toqa.fleet.floor;

/** What people have said of a robot. Only {@link OperatorCommandHandler} changes it. */
final class OperatorSettings {
  private boolean inService;
  private boolean held;

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
