package org.toqa.planning.smooth;

/** What the planner answers: a path, or the named reason why there is none. */
public sealed interface SmoothResult {

  record Found(WayPath path) implements SmoothResult {}

  record NotFound(Reason reason) implements SmoothResult {}

  enum Reason {
    /** At the start the disc overlaps a wall or leaves the grid. */
    START_BLOCKED,
    /** The same at the goal. */
    GOAL_BLOCKED,
    /** Walls part the goal from the start: there is no path. */
    NO_PATH,
    /** None was found in time; there may be one. */
    OUT_OF_TIME
  }
}
