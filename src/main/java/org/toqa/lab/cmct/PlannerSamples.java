package org.toqa.lab.cmct;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.toqa.grid.Cell;
import org.toqa.lab.cmct.PlannerMethod.Planned;
import org.toqa.lab.experiment.Run;
import org.toqa.planning.exact.ShortestDiscPath;

/** What all planners do in many scenes of one kind, summed up over the first tasks of each. */
final class PlannerSamples {
  static final int TASKS = 10;

  /** Metres: the planners know points only, and this is as good as one. */
  private static final double POINT = 1e-6;

  private static final int TIMED = 3;

  private final Map<PlannerMethod, List<List<Sum>>> sums = new EnumMap<>(PlannerMethod.class);
  private final List<List<Double>> shortest = new ArrayList<>();
  private final List<StoreScene> scenes = new ArrayList<>();

  /**
   * Over the first tasks of a scene.
   *
   * @param metres driven
   * @param micros of planning, by this machine
   * @param visited points
   * @param kept the most points in lists at once, of one plan
   */
  record Sum(double metres, double micros, long visited, int kept) {
    Sum plus(Sum other) {
      return new Sum(
          metres + other.metres,
          micros + other.micros,
          visited + other.visited,
          Math.max(kept, other.kept));
    }
  }

  /** Plans in as many scenes as are asked for, in each of the runs. */
  static PlannerSamples of(Run run, int scenes, double density) {
    PlannerSamples samples = new PlannerSamples();
    for (PlannerMethod method : PlannerMethod.values()) {
      samples.sums.put(method, new ArrayList<>());
    }
    for (int i = 0; i < run.runs(); i++) {
      SplittableRandom random = new SplittableRandom(run.seedOf(i));
      for (int scene = 0; scene < scenes; scene++) {
        run.checkStopped();
        samples.add(StoreScene.of(density, TASKS, random));
      }
    }
    return samples;
  }

  private void add(StoreScene scene) {
    scenes.add(scene);
    for (PlannerMethod method : PlannerMethod.values()) {
      List<Sum> byTasks = new ArrayList<>();
      Sum sum = new Sum(0, 0, 0, 0);
      for (int task = 0; task < TASKS; task++) {
        sum = sum.plus(drive(method, scene, 2 * task)).plus(drive(method, scene, 2 * task + 1));
        byTasks.add(sum);
      }
      sums.getOrDefault(method, List.of()).add(byTasks);
    }
    ShortestDiscPath exact = new ShortestDiscPath(scene.grid(), POINT);
    List<Double> byTasks = new ArrayList<>();
    double metres = 0;
    for (int task = 0; task < TASKS; task++) {
      metres += shortest(exact, scene, 2 * task) + shortest(exact, scene, 2 * task + 1);
      byTasks.add(metres);
    }
    shortest.add(byTasks);
  }

  private static double shortest(ShortestDiscPath exact, StoreScene scene, int from) {
    return exact
        .length(
            scene.grid().centre(scene.places().get(from)),
            scene.grid().centre(scene.places().get(from + 1)))
        .orElseThrow();
  }

  private static Sum drive(PlannerMethod method, StoreScene scene, int from) {
    Cell start = scene.places().get(from);
    Cell goal = scene.places().get(from + 1);
    Planned planned = method.plan(scene.grid(), start, goal);
    long nanos = Long.MAX_VALUE;
    for (int i = 0; i < TIMED; i++) {
      long begin = System.nanoTime();
      method.plan(scene.grid(), start, goal);
      nanos = Math.min(nanos, System.nanoTime() - begin);
    }
    return new Sum(
        planned.length(), nanos / 1e3, planned.effort().visited(), planned.effort().kept());
  }

  List<StoreScene> scenes() {
    return scenes;
  }

  /**
   * Of each scene, its first tasks together.
   *
   * @param tasks 1 to 10
   */
  double[] values(PlannerMethod method, int tasks, ToDoubleFunction<Sum> value) {
    return sums.getOrDefault(method, List.of()).stream()
        .mapToDouble(byTasks -> value.applyAsDouble(byTasks.get(tasks - 1)))
        .toArray();
  }

  /** The exact shortest of each scene, metres. */
  double[] shortest(int tasks) {
    return shortest.stream().mapToDouble(byTasks -> byTasks.get(tasks - 1)).toArray();
  }
}
