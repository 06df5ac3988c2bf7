package org.toqa.allocation;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
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

  /** A share of the battery that is left to a robot for detours when it gets to a charger. */
  private static final double RESERVE = 0.05;

  private final Travel travel;
  private final List<ToDoubleFunction<Vec2>> fromChargers;

  /**
   * @param chargers the floor's charging points, metres, map frame; without any, nobody looks
   *     whether a battery lasts
   */
  Costs(Travel travel, List<Vec2> chargers) {
    this.travel = travel;
    fromChargers = chargers.stream().map(travel::from).toList();
  }

  Costs(Situation situation) {
    this(situation.travel(), situation.chargers());
  }

  /** Why a robot cannot do a task. */
  enum Obstacle {
    TOO_WEAK,
    NO_WAY,
    /** It would not get to a charger after it. */
    BATTERY
  }

  /**
   * One robot's part.
   *
   * @param approach metres to the load
   * @param joules {@link #IMPOSSIBLE} where something speaks against it
   * @param obstacle null where nothing does
   */
  record Cost(double approach, double joules, @Nullable Obstacle obstacle) {
    static Cost impossible(double approach, Obstacle obstacle) {
      return new Cost(approach, IMPOSSIBLE, obstacle);
    }

    boolean isPossible() {
      return obstacle == null;
    }
  }

  /** The costs of a task, by robot, in the order of the robots. */
  List<Cost> of(Job job, List<Candidate> robots) {
    ToDoubleFunction<Vec2> lengths = travel.from(job.start());
    double carried = lengths.applyAsDouble(job.goal());
    double toCharger = toCharger(job.goal());
    return robots.stream()
        .map(r -> cost(job, r, lengths.applyAsDouble(r.position()), carried, toCharger))
        .toList();
  }

  Cost of(Job job, Candidate robot) {
    return of(job, List.of(robot)).getFirst();
  }

  /** Metres to the nearest charger; 0 where there is none. */
  private double toCharger(Vec2 place) {
    return fromChargers.stream().mapToDouble(from -> from.applyAsDouble(place)).min().orElse(0);
  }

  private Cost cost(Job job, Candidate robot, double approach, double carried, double toCharger) {
    if (!robot.isStrongEnough(job)) {
      return Cost.impossible(approach, Obstacle.TOO_WEAK);
    }
    if (Double.isInfinite(approach + carried)) {
      return Cost.impossible(approach, Obstacle.NO_WAY);
    }
    double charge = robot.battery() == null ? 1 : robot.battery();
    double used =
        Energy.joules(approach, 0)
            + Energy.joules(carried, job.load())
            + Energy.joules(toCharger, 0);
    if (!fromChargers.isEmpty() && used > (charge - RESERVE) * Energy.BATTERY) {
      return Cost.impossible(approach, Obstacle.BATTERY);
    }
    double spare = robot.maxLoad() - job.load();
    double metres =
        approach * (1 + EMPTY_BATTERY * (1 - charge)) + DETOUR_PER_SPARE_KILOGRAM * spare;
    return new Cost(approach, Energy.joules(metres, 0) + Energy.joules(carried, job.load()), null);
  }
}
