package org.toqa.fleet.history;

/** Adds up how much a robot's battery falls. Where it rises, that is not subtracted. */
final class BatteryDrain {
  /** Less may be the error of its measurement. */
  private static final double STEP = 0.005;

  private double counted = Double.NaN;

  /**
   * How much is to be added now.
   *
   * @param battery 0 to 1
   */
  double add(double battery) {
    double fallen = counted - battery;
    if (Math.abs(fallen) < STEP) {
      return 0;
    }
    counted = battery;
    return fallen > 0 ? fallen : 0;
  }
}
