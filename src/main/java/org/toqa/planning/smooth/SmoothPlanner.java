package org.toqa.planning.smooth;

import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.planning.smooth.SmoothResult.Found;
import org.toqa.planning.smooth.SmoothResult.NotFound;
import org.toqa.planning.smooth.SmoothResult.Reason;

/**
 * Plans a short path for a disc: hybrid RRT* and particle swarm (CSM-MAMRS). It is anytime: it ends
 * when its budget is spent, and the longer it may take the shorter the path; never longer. With a
 * budget of iterations it is a function of its arguments, the seed among them.
 *
 * <p>Where there is a path it is found, given time: a first one is searched on lattices, of which
 * the first takes little time and the others become finer ({@link FirstPathFinder}). That there is
 * none is known exactly ({@link Connectivity}), not by giving up. It keeps nothing, and any thread
 * may call it.
 */
public final class SmoothPlanner {
  private final SmoothMethod method;
  private final long seed;

  /**
   * @param seed of the random numbers
   */
  public SmoothPlanner(SmoothMethod method, long seed) {
    this.method = method;
    this.seed = seed;
  }

  /**
   * Plans a path.
   *
   * @param from where the disc's centre starts, metres, map frame
   * @param to where it shall go, metres, map frame
   */
  public SmoothResult plan(DiscSpace space, Vec2 from, Vec2 to, PlanningBudget budget) {
    if (!space.isFree(from)) {
      return new NotFound(Reason.START_BLOCKED);
    }
    if (!space.isFree(to)) {
      return new NotFound(Reason.GOAL_BLOCKED);
    }
    if (from.equals(to)) {
      return new Found(new WayPath(List.of(from), List.of(new WayPath.Progress(0, 0))));
    }
    if (space.isFree(from, to)) {
      WayPath.Progress only = new WayPath.Progress(0, from.distanceTo(to));
      return new Found(new WayPath(List.of(from, to), List.of(only)));
    }
    PlanningRun run = new PlanningRun(space, from, to, method, seed, budget);
    return run.plan();
  }
}
