package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

/** A vertex to which a robot goes before its goal, for some steps at most. */
final class Detour {
  private int vertex = NONE;
  private int stepsLeft;

  /** {@code NONE} where it has none. */
  int vertex() {
    return vertex;
  }

  boolean isActive() {
    return vertex != NONE;
  }

  void start(int to, int steps) {
    vertex = to;
    stepsLeft = steps;
  }

  void end() {
    vertex = NONE;
  }

  /**
   * Counts a step of the robot.
   *
   * @param at where the robot is, a vertex
   * @return whether that was the last one: it is there, or has gone on long enough
   */
  boolean countStep(int at) {
    return isActive() && (at == vertex || stepsLeft-- == 0);
  }
}
