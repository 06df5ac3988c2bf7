package org.toqa.traffic.floor;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * What planning answers to a request. Immutable: any thread may read it.
 *
 * @param paths of the robots whose paths are to go on otherwise, in the order of their names
 * @param jointOutcome of planning robots together; null: it was not due or not needed
 * @param findings by the name of each robot
 */
record FloorPlan(
    PlanningRequest request,
    List<ProposedPath> paths,
    @Nullable LaneOutcome jointOutcome,
    Map<String, WaitState.Findings> findings) {
  FloorPlan {
    paths = List.copyOf(paths);
    findings = Map.copyOf(findings);
  }

  /** Whether robots have paths by a plan for all of them. */
  boolean isJoint() {
    return jointOutcome == LaneOutcome.PLANNED || isPlannedAhead();
  }

  /** Whether these are only the next steps. */
  boolean isPlannedAhead() {
    return jointOutcome == LaneOutcome.PLANNED_AHEAD;
  }
}
