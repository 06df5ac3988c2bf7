package org.toqa.lab.csm;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.lab.drawing.Chart;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.PlanningBudget;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.SmoothPlanner;
import org.toqa.planning.smooth.SmoothResult;
import org.toqa.planning.smooth.WayPath;

/**
 * What one method makes of a floor.
 *
 * @param path the straight lines that it found; null where it found none
 * @param milliseconds of computing
 */
record PlannedPath(SmoothMethod method, @Nullable WayPath path, double milliseconds) {

  static PlannedPath of(
      SmoothMethod method, DiscSpace space, CsmFloor floor, long iterations, long seed) {
    long begin = System.nanoTime();
    SmoothResult result =
        new SmoothPlanner(method, seed)
            .plan(space, floor.start(), floor.goal(), PlanningBudget.iterations(iterations));
    double milliseconds = (System.nanoTime() - begin) / 1e6;
    WayPath path = result instanceof SmoothResult.Found(WayPath found) ? found : null;
    return new PlannedPath(method, path, milliseconds);
  }

  /** Centimetres; not a number where there is no path. */
  double centimetres() {
    return path == null ? Double.NaN : 100 * Vec2.lengthOf(path.points());
  }

  /** The iteration after which the path was no more than a thousandth longer than at the end. */
  long settledAfter() {
    if (path == null) {
      return -1;
    }
    double last = path.progress().getLast().length();
    return path.progress().stream()
        .filter(shorter -> shorter.length() <= 1.001 * last)
        .findFirst()
        .orElseThrow()
        .iteration();
  }

  /** The best cost by iteration, as steps. */
  Chart.Series series(long iterations) {
    List<Chart.Point> points = new ArrayList<>();
    if (path != null) {
      double before = Double.NaN;
      for (WayPath.Progress shorter : path.progress()) {
        points.add(new Chart.Point(shorter.iteration(), before));
        before = 100 * shorter.length();
        points.add(new Chart.Point(shorter.iteration(), before));
      }
      points.add(new Chart.Point(iterations, before));
    }
    return new Chart.Series(name(), points);
  }

  String name() {
    return switch (method) {
      case RRT_STAR -> "RRT* alone";
      case PARTICLE_SWARM -> "particle swarm alone";
      case HYBRID -> "both";
    };
  }
}
