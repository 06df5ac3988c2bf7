package org.toqa.planning.cmct;

import java.util.List;
import org.toqa.grid.Cell;

/** What a planner on a lattice answers: a path, or the named reason why there is none. */
public sealed interface LatticeResult {

  /** What it took to find out. */
  Effort effort();

  /**
   * @param points from start to goal, each a move from the one before it
   */
  record Found(List<Cell> points, Effort effort) implements LatticeResult {
    public Found {
      points = List.copyOf(points);
    }
  }

  record NotFound(Reason reason, Effort effort) implements LatticeResult {}

  enum Reason {
    START_BLOCKED,
    GOAL_BLOCKED,
    /** Obstacles part the goal from the start. */
    NO_PATH,
    /** The planner keeps too little in mind to say whether there is a path. */
    GAVE_UP
  }

  /**
   * What a plan costs, counted.
   *
   * @param visited points that were stepped on, or expanded; each time counts
   * @param kept the most points that were in lists at once, the path itself apart
   */
  record Effort(long visited, int kept) {}
}
