package org.toqa.traffic.mapf;

import org.jspecify.annotations.Nullable;
import org.toqa.grid.Cell;

/** What one-shot planning comes to. */
public sealed interface MapfResult {

  /**
   * @param lowerBound the sum of the shortest paths of the robots, were each alone
   */
  record Solved(MapfPlan plan, long lowerBound) implements MapfResult {}

  /**
   * @param robot whom the reason is about, or null where it is about all
   */
  record Unsolved(Reason reason, @Nullable Culprit robot) implements MapfResult {}

  /**
   * @param index the robot's place in the instance, from 0
   * @param cell the start or the goal that the reason is about
   */
  record Culprit(int index, Cell cell) {}

  enum Reason {
    /** The robot's start is not free. */
    START_BLOCKED,
    /** The robot's goal is not free. */
    GOAL_BLOCKED,
    /** Another robot has the same start. */
    START_SHARED,
    /** Another robot has the same goal. */
    GOAL_SHARED,
    /** The robot has no path to its goal, even alone. */
    NO_WAY,
    /** The whole search space was explored: the robots cannot all reach their goals together. */
    NO_PLAN,
    OUT_OF_TIME
  }
}
