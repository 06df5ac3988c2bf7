package org.toqa.agent.firmware;

import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * Tells from the voltage of four lithium polymer cells how full they are: by the curve of cells at
 * rest, and smoothed, since wheels that draw current pull the voltage down.
 */
final class BatteryGauge {
  private static final int CELLS = 4;

  /** Of the whole battery: the microcontroller stops the robot there. */
  static final double EMPTY_VOLTS = CELLS * 3.3;

  /** Longer than a robot takes to set off or to turn, seconds. */
  private static final double TIME_CONSTANT = 20;

  /**
   * By volts of a cell at rest: usual values of lithium polymer cells; 0 is what is left at 3.3 V.
   */
  private static final NavigableMap<Double, Double> CHARGE =
      new TreeMap<>(
          Map.ofEntries(
              Map.entry(3.30, 0.00),
              Map.entry(3.61, 0.05),
              Map.entry(3.69, 0.10),
              Map.entry(3.71, 0.15),
              Map.entry(3.73, 0.20),
              Map.entry(3.77, 0.30),
              Map.entry(3.80, 0.40),
              Map.entry(3.84, 0.50),
              Map.entry(3.87, 0.60),
              Map.entry(3.95, 0.70),
              Map.entry(4.02, 0.80),
              Map.entry(4.11, 0.90),
              Map.entry(4.20, 1.00)));

  /** Volts; less is told before the first measurement. */
  private static final double NOT_MEASURED = 1;

  private double volts = Double.NaN;

  /**
   * @param measured volts of the whole battery
   * @param seconds since the last measurement
   */
  void update(double measured, double seconds) {
    if (measured < NOT_MEASURED) {
      return;
    }
    // v += (measured - v) (1 - exp(-t/T))
    volts =
        Double.isNaN(volts)
            ? measured
            : volts + (measured - volts) * -Math.expm1(-Math.max(0, seconds) / TIME_CONSTANT);
  }

  /** It may be another battery now. */
  void reset() {
    volts = Double.NaN;
  }

  /** 0 to 1; 0 before the first measurement. */
  double charge() {
    return Double.isNaN(volts) ? 0 : charge(volts / CELLS);
  }

  private static double charge(double cell) {
    var below = CHARGE.floorEntry(cell);
    var above = CHARGE.higherEntry(cell);
    if (below == null || above == null) {
      return below == null ? 0 : 1;
    }
    double part = (cell - below.getKey()) / (above.getKey() - below.getKey());
    return below.getValue() + part * (above.getValue() - below.getValue());
  }
}
