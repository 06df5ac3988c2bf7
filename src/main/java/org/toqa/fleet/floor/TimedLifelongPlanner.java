package org.toqa.fleet.floor;

import org.toqa.fleet.FleetRuntime;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.lifelong.LifelongPlan;
import org.toqa.traffic.lifelong.LifelongPlanner;
import org.toqa.traffic.lifelong.TrafficSnapshot;

/** Tells the runtime how long each plan of another planner takes. */
record TimedLifelongPlanner(LifelongPlanner planner, FleetRuntime runtime)
    implements LifelongPlanner {

  @Override
  public LifelongPlan plan(TrafficSnapshot snapshot, Deadline deadline) {
    long begin = System.nanoTime();
    try {
      return planner.plan(snapshot, deadline);
    } finally {
      runtime.recordPlanning(System.nanoTime() - begin);
    }
  }
}
