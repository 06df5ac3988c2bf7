package org.toqa.allocation;

import java.util.List;

/** What robots would carry loads for: computed here, or said by the robots' agents. */
interface Quotes {

  /** Of a task for robots, in their order. */
  List<Quote> of(AllocationTask task, List<Candidate> robots);

  default Quote of(AllocationTask task, Candidate robot) {
    return of(task, List.of(robot)).getFirst();
  }

  /** Whether the path from start to goal is wide enough for the robot. */
  boolean hasPathFor(AllocationTask task, Candidate robot);
}
