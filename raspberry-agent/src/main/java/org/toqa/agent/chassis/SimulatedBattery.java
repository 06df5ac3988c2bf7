package org.toqa.agent.chassis;

import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * The battery of a simulated body: it drains by time, distance and load, and is charged while the
 * body is at a charging point.
 *
 * @param initialLevel what the battery of a new body has, 0 to 1
 * @param chargers charging points, metres, map frame; looked at in every step, for others may take
 *     their place
 */
public record SimulatedBattery(double initialLevel, List<Vec2> chargers) {

  /** A new body begins with a full battery, and there is nowhere to charge it. */
  public static final SimulatedBattery FULL = new SimulatedBattery(1, List.of());

  /** Eight hours of standstill, or 80 minutes of driving at 0.25 m/s, empty the battery. */
  private static final double DRAIN_A_SECOND = 1 / 28_800.0;

  private static final double DRAIN_A_METRE = 1 / 1_440.0;

  /** Assumed: 1.5 J of the battery's 106,560 J, for the rolling resistance of each kilogram. */
  private static final double DRAIN_A_METRE_AND_KILOGRAM = 1.5 / 106_560.0;

  /** An empty battery is full after half an hour. */
  private static final double CHARGE_A_SECOND = 1 / 1_800.0;

  /** Metres; a body that is stopped so near to a charging point has docked. */
  private static final double DOCKED_METRES = 0.15;

  /** Whether a body that is stopped there is charged. */
  boolean isDocked(Pose place) {
    Vec2 here = place.position();
    for (Vec2 point : chargers) { // at every step of every body that stands
      if (point.distanceTo(here) < DOCKED_METRES) {
        return true;
      }
    }
    return false;
  }

  /**
   * What the battery has after a while, 0 to 1.
   *
   * @param metres driven meanwhile
   * @param load kilograms on board
   */
  double levelAfterDriving(double level, double seconds, double metres, double load) {
    double used =
        DRAIN_A_SECOND * seconds + (DRAIN_A_METRE + DRAIN_A_METRE_AND_KILOGRAM * load) * metres;
    return Math.max(0, level - used);
  }

  double levelAfterCharging(double level, double seconds) {
    return Math.min(1, level + CHARGE_A_SECOND * seconds);
  }
}
