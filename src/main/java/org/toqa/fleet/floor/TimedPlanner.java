package org.toqa.fleet.floor;

import java.util.List;
import java.util.Optional;
import org.toqa.fleet.FleetRuntime;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/** Tells the runtime how long each plan of another planner takes. */
record TimedPlanner(JointPlanner planner, FleetRuntime runtime) implements JointPlanner {

  @Override
  public Optional<List<int[]>> plan(
      RoadGraph roads, Spacing spacing, int[] starts, int[] goals, Deadline deadline) {
    long begin = System.nanoTime();
    try {
      return planner.plan(roads, spacing, starts, goals, deadline);
    } finally {
      runtime.recordPlanning(System.nanoTime() - begin);
    }
  }
}
