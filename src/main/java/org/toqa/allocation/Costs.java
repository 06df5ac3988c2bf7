package org.toqa.allocation;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * What it costs that a robot carries a load, in joules: the energy of its path to the load and with
 * it, and what speaks against this robot besides.
 */
final class Costs {
  /** No robot does this. */
  static final double IMPOSSIBLE = Double.POSITIVE_INFINITY;

  /** An empty battery makes the path to the load count half as much again. */
  private static final double EMPTY_BATTERY = 0.5;

  /** A robot that is too strong by a kilogram is worth this detour, metres. */
  private static final double DETOUR_PER_SPARE_KILOGRAM = 0.25;

  /** Metres per second: a robot that is slower by half is worth a detour as long as its path. */
  private static final double USUAL_SPEED = 0.25;

  private final PathLengths pathLengths;
  private final List<Vec2> chargers;

  /**
   * @param chargers the floor's charging points, metres, map frame; without any, nobody looks
   *     whether a battery lasts
   */
  Costs(PathLengths pathLengths, List<Vec2> chargers) {
    this.pathLengths = pathLengths;
    this.chargers = List.copyOf(chargers);
  }

  Costs(AllocationProblem problem) {
    this(problem.pathLengths(), problem.chargers());
  }

  /** Why a robot cannot do a task. */
  enum Impediment {
    TOO_WEAK,
    NO_PATH,
    /** It would not get to a charger after it. */
    BATTERY
  }

  /**
   * One robot's part.
   *
   * @param approach metres to the load
   * @param joules {@link #IMPOSSIBLE} where something speaks against it
   * @param impediment null where nothing does
   */
  record Cost(double approach, double joules, @Nullable Impediment impediment) {
    static Cost impossible(double approach, Impediment obstacle) {
      return new Cost(approach, IMPOSSIBLE, obstacle);
    }

    boolean isPossible() {
      return impediment == null;
    }
  }

  /** The costs of a task for robots, in their order. */
  List<Cost> of(AllocationTask task, List<Candidate> robots) {
    Map<Double, TaskPaths> byDiameter = new HashMap<>();
    return robots.stream()
        .map(
            r ->
                cost(
                    task, r, byDiameter.computeIfAbsent(r.diameter(), d -> new TaskPaths(task, d))))
        .toList();
  }

  Cost of(AllocationTask task, Candidate robot) {
    return of(task, List.of(robot)).getFirst();
  }

  /** Whether the path from start to goal is wide enough for the robot. */
  boolean hasPathFor(AllocationTask task, Candidate robot) {
    return Double.isFinite(
        pathLengths.lengthsFrom(task.start(), robot.diameter()).applyAsDouble(task.goal()));
  }

  /** How long the paths of a task are, metres, for robots of one diameter. */
  private final class TaskPaths {
    final ToDoubleFunction<Vec2> toLoad;
    final double carried;

    /** Metres to the nearest charger; 0 where there is none. */
    final double toCharger;

    TaskPaths(AllocationTask task, double diameter) {
      toLoad = pathLengths.lengthsFrom(task.start(), diameter);
      carried = toLoad.applyAsDouble(task.goal());
      toCharger =
          chargers.stream()
              .mapToDouble(c -> pathLengths.lengthsFrom(c, diameter).applyAsDouble(task.goal()))
              .min()
              .orElse(0);
    }
  }

  private static double slowness(Candidate robot) {
    return Math.max(1, USUAL_SPEED / robot.speed());
  }

  private Cost cost(AllocationTask task, Candidate robot, TaskPaths paths) {
    double approach = paths.toLoad.applyAsDouble(robot.position());
    double carried = paths.carried;
    if (!robot.isStrongEnough(task)) {
      return Cost.impossible(approach, Impediment.TOO_WEAK);
    }
    if (Double.isInfinite(approach + carried)) {
      return Cost.impossible(approach, Impediment.NO_PATH);
    }
    double charge = robot.battery() == null ? 1 : robot.battery();
    double used =
        Energy.joules(approach, 0)
            + Energy.joules(carried, task.load())
            + Energy.joules(paths.toCharger, 0);
    if (!chargers.isEmpty() && used > (charge - Energy.RESERVE) * Energy.BATTERY_JOULES) {
      return Cost.impossible(approach, Impediment.BATTERY);
    }
    double spare = robot.maxLoad() - task.load();
    double metres =
        slowness(robot) * approach * (1 + EMPTY_BATTERY * (1 - charge))
            + DETOUR_PER_SPARE_KILOGRAM * spare;
    double joules =
        Energy.joules(metres, 0) + slowness(robot) * Energy.joules(carried, task.load());
    return new Cost(approach, joules, null);
  }
}
