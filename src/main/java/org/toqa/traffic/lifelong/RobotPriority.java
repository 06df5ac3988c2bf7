package org.toqa.traffic.lifelong;

/**
 * How early a robot's turn is: the nearer it is to its goal, and the longer it has travelled, but
 * for a few exceptional steps. Near ones first, since each that arrives is out of the others' way;
 * who is far away waits its turn, and that comes, since every step counts.
 */
final class RobotPriority {
  private static final int BEHIND_ALL = Integer.MIN_VALUE / 2;
  private static final int BEFORE_ALL = Integer.MAX_VALUE / 2;

  /** What a step on the way counts for, in the unit of costs. */
  private static final int AGING = Guidance.STEP / 2;

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
   * @param toGo costs to the goal, as {@link Guidance} has them
   * @return the more, the earlier its turn
   */
  int value(int urgency, int toGo) {
    if (exceptionStepsLeft > 0) {
      return exceptionalPriority;
    }
    long steps = (long) stepsTravelled + Math.max(0, urgency);
    return (int) Math.min(BEFORE_ALL, AGING * steps - toGo);
  }
}
