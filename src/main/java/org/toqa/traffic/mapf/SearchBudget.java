package org.toqa.traffic.mapf;

import org.toqa.traffic.Deadline;

/** How long a search may go on making a plan better: iterations, and a deadline. */
final class SearchBudget {
  private final Deadline deadline;
  private long iterationsLeft;

  SearchBudget(Deadline deadline, long iterations) {
    this.deadline = deadline;
    this.iterationsLeft = iterations;
  }

  /** Only the deadline ends it. */
  static SearchBudget until(Deadline deadline) {
    return new SearchBudget(deadline, Long.MAX_VALUE);
  }

  /**
   * Takes one iteration.
   *
   * @return whether there was one left, and time for it
   */
  boolean takeIteration() {
    return iterationsLeft-- > 0 && !deadline.isPassed();
  }

  /** Whether there is no iteration left, or no time for one. */
  boolean isUsedUp() {
    return iterationsLeft <= 0 || deadline.isPassed();
  }
}
