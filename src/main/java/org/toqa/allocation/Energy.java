package org.toqa.allocation;

/** What driving costs. */
public final class Energy {
  /** What a full battery holds, joules: 4 cells of 3.7 V and 2 Ah (Tanta, "Robot"). */
  public static final double BATTERY_JOULES = 4 * 3.7 * 2 * 3600;

  /** The share of a battery that is left to a robot for detours when it gets to a charger. */
  public static final double RESERVE = 0.05;

  /** It lasts 80 minutes at 0.25 m/s: 1200 m. */
  private static final double JOULES_PER_METRE = BATTERY_JOULES / 1200;

  /** Assumed, of each kilogram: 0.05 * 9.81 N of rolling resistance, by drives of 33 percent. */
  private static final double JOULES_PER_METRE_AND_KILOGRAM = 1.5;

  private Energy() {}

  /**
   * Joules.
   *
   * @param metres of the path
   * @param load kilograms on board
   */
  public static double joules(double metres, double load) {
    return metres * (JOULES_PER_METRE + JOULES_PER_METRE_AND_KILOGRAM * load);
  }
}
