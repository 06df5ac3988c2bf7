package org.toqa.allocation;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.toqa.geometry.Vec2;

/**
 * What it costs that a robot carries a load, in joules: the energy of its way to the load and with
 * it, and what speaks against this robot besides.
 */
final class Costs {
  /** No robot does this. */
  static final double IMPOSSIBLE = Double.POSITIVE_INFINITY;

  /** An empty battery makes the way to the load count half as much again. */
  private static final double EMPTY_BATTERY = 0.5;

  /** A robot that is too strong by a kilogram is worth this detour, metres. */
  private static final double DETOUR_PER_SPARE_KILOGRAM = 0.25;

  private final Travel travel;

  Costs(Travel travel) {
    this.travel = travel;
  }

  /**
   * One robot's part.
   *
   * @param approach metres to the load
   * @param joules {@link #IMPOSSIBLE} where it is too weak or finds no way
   */
  record Cost(double approach, double joules) {
    boolean isPossible() {
      return joules < IMPOSSIBLE;
    }
  }

  /** The costs of a task, by robot, in the order of the robots. */
  List<Cost> of(Job job, List<Candidate> robots) {
    ToDoubleFunction<Vec2> lengths = travel.from(job.start());
    double carried = lengths.applyAsDouble(job.goal());
    return robots.stream()
        .map(r -> cost(job, r, lengths.applyAsDouble(r.position()), carried))
        .toList();
  }

  Cost of(Job job, Candidate robot) {
    return of(job, List.of(robot)).getFirst();
  }

  private static Cost cost(Job job, Candidate robot, double approach, double carried) {
    if (!robot.isStrongEnough(job)) {
      return new Cost(approach, IMPOSSIBLE);
    }
    double charge = robot.battery() == null ? 1 : robot.battery();
    double spare = robot.maxLoad() - job.load();
    double metres =
        approach * (1 + EMPTY_BATTERY * (1 - charge)) + DETOUR_PER_SPARE_KILOGRAM * spare;
    return new Cost(approach, Energy.joules(metres, 0) + Energy.joules(carried, job.load()));
  }
}
