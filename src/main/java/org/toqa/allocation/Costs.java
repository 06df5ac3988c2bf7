package org.toqa.allocation;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What it costs that a robot carries a load, in joules: the energy of its path to the load and with
 * it, and what speaks against this robot besides.
 */
final class Costs implements Quotes {
  /** An empty battery makes the path to the load count half as much again. */
  private static final double EMPTY_BATTERY = 0.5;

  /** A robot that is too strong by a kilogram is worth this detour, metres. */
  private static final double DETOUR_PER_SPARE_KILOGRAM = 0.25;

  /** Metres per second: a robot that is slower by half is worth a detour as long as its path. */
  private static final double USUAL_SPEED = 0.25;

  private final PathLengths pathLengths;
  private final List<Vec2> chargers;

  Costs(Terrain terrain) {
    this.pathLengths = terrain.pathLengths();
    this.chargers = terrain.chargers();
  }

  @Override
  public List<Quote> of(AllocationTask task, List<Candidate> robots) {
    Map<Double, TaskPaths> byDiameter = new HashMap<>();
    return robots.stream()
        .map(
            r ->
                quote(
                    task, r, byDiameter.computeIfAbsent(r.diameter(), d -> new TaskPaths(task, d))))
        .toList();
  }

  @Override
  public boolean hasPathFor(AllocationTask task, Candidate robot) {
    return Double.isFinite(carriedMetres(task, robot.diameter()));
  }

  /** From its start along its stops to its goal; infinite where that is no way. */
  private double carriedMetres(AllocationTask task, double diameter) {
    double metres = 0;
    Vec2 from = task.start();
    for (Vec2 stop : task.via()) {
      metres += pathLengths.length(from, stop, diameter);
      from = stop;
    }
    return metres + pathLengths.length(from, task.goal(), diameter);
  }

  /** How long the paths of a task are, metres, for robots of one diameter. */
  private final class TaskPaths {
    final ToDoubleFunction<Vec2> toLoad;
    final double carried;

    /** Metres to the nearest charger; 0 where there is none. */
    final double toCharger;

    TaskPaths(AllocationTask task, double diameter) {
      toLoad = pathLengths.lengthsTo(task.start(), diameter);
      carried = carriedMetres(task, diameter);
      toCharger =
          chargers.stream()
              .mapToDouble(c -> pathLengths.lengthsTo(c, diameter).applyAsDouble(task.goal()))
              .min()
              .orElse(0);
    }
  }

  private static double slowness(Candidate robot) {
    return Math.max(1, USUAL_SPEED / robot.speed());
  }

  private Quote quote(AllocationTask task, Candidate robot, TaskPaths paths) {
    double approach = paths.toLoad.applyAsDouble(robot.position());
    double carried = paths.carried;
    if (!task.allows(robot.robot())) {
      return Quote.impossible(approach, Impediment.NOT_CHOSEN, Phrase.IS_NOT_CHOSEN.with());
    }
    if (!robot.isStrongEnough(task)) {
      return Quote.impossible(approach, Impediment.TOO_WEAK, Phrase.IS_TOO_WEAK.with());
    }
    if (Double.isInfinite(approach + carried)) {
      return Quote.impossible(approach, Impediment.NO_PATH, noWay(task).with(robot.diameter()));
    }
    double charge = robot.battery() == null ? 1 : robot.battery();
    double used =
        Energy.joules(approach, 0)
            + Energy.joules(carried, task.load())
            + Energy.joules(paths.toCharger, 0);
    if (!chargers.isEmpty() && used > (charge - Energy.RESERVE) * Energy.BATTERY_JOULES) {
      return Quote.impossible(approach, Impediment.BATTERY, lowBattery(robot));
    }
    double spare = robot.maxLoad() - task.load();
    double metres =
        slowness(robot) * approach * (1 + EMPTY_BATTERY * (1 - charge))
            + DETOUR_PER_SPARE_KILOGRAM * spare;
    double joules =
        Energy.joules(metres, 0) + slowness(robot) * Energy.joules(carried, task.load());
    return Quote.possible(approach, joules);
  }

  private static Phrase noWay(AllocationTask task) {
    return task.isDrive() ? Phrase.FINDS_NO_WAY_TO_DRIVE : Phrase.FINDS_NO_WAY;
  }

  private static Sentence lowBattery(Candidate robot) {
    Double battery = robot.battery();
    return battery == null
        ? Phrase.WOULD_NOT_REACH_CHARGER.with()
        : Phrase.WOULD_NOT_REACH_CHARGER_WITH.with(Math.round(100 * battery));
  }
}
