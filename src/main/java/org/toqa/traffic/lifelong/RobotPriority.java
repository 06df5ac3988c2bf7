package org.toqa.traffic.lifelong;

/** How early a robot's turn is: the longer it has travelled, but for a few exceptional steps. */
final class RobotPriority {
  private static final int BEHIND_ALL = -1;
  private static final int BEFORE_ALL = Integer.MAX_VALUE / 2;

  /** Steps on the path to its goal. */
  private int stepsTravelled;

  /** Steps for which it has another priority than its own, and which one. */
  private int exceptionStepsLeft;

  private int exceptionalPriority;

  /** Its path to another goal begins. */
  void restart() {
    stepsTravelled = 0;
    exceptionStepsLeft = 0;
  }

  /** A step of time has passed. */
  void countStep() {
    exceptionStepsLeft = Math.max(0, exceptionStepsLeft - 1);
  }

  /** It was a step on the path to its goal. */
  void countStepTravelled() {
    stepsTravelled++;
  }

  void goBeforeAll(int steps) {
    exceptionalPriority = BEFORE_ALL;
    exceptionStepsLeft = steps;
  }

  void goBehindAll(int steps) {
    exceptionalPriority = BEHIND_ALL;
    exceptionStepsLeft = steps;
  }

  void endException() {
    exceptionStepsLeft = 0;
  }

  /**
   * @param urgency a head start, in steps; below 0 counts as 0
   * @return the more, the earlier its turn
   */
  int value(int urgency) {
    int own = Math.min(BEFORE_ALL, stepsTravelled + Math.max(0, urgency));
    return exceptionStepsLeft > 0 ? exceptionalPriority : own;
  }
}
