package org.toqa.planning;

import org.toqa.grid.Cell;

/** What a planner answers: a path, or the named reason why there is none. */
public sealed interface PlanResult {

  record Found(Path path) implements PlanResult {}

  /**
   * @param where the cell that the reason is about
   */
  record NotFound(Reason reason, Cell where) implements PlanResult {}

  enum Reason {
    START_BLOCKED,
    GOAL_BLOCKED,
    NO_PATH,
    /** The planner keeps too little in mind to say whether there is a path. */
    GAVE_UP
  }
}
