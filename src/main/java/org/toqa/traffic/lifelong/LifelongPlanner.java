package org.toqa.traffic.lifelong;

import org.toqa.traffic.Deadline;

/**
 * Plans for all robots of a floor together, a few steps ahead.
 *
 * <ol>
 *   <li>The caller describes the floor as it is now: where the robots are, where they want to be,
 *       what is blocked.
 *   <li>{@link #plan} answers the next steps of every robot. They hold together: no two share a
 *       cell or change places if all go step by step. Whoever is late must not be overtaken.
 *   <li>The caller drives as much of it as it likes, at least one step, and asks again. It need not
 *       have been obeyed: robots may be elsewhere, gone, new, or want something else.
 * </ol>
 *
 * A planner remembers from call to call how long each robot has waited, so that nobody waits for
 * ever. The same calls on a planner made with the same seed give the same plans, as long as no
 * deadline passes. One thread at a time may call it.
 */
public interface LifelongPlanner {

  /**
   * @param deadline when to answer with what there is; a plan is valid at any time
   */
  LifelongPlan plan(TrafficSnapshot snapshot, Deadline deadline);
}
