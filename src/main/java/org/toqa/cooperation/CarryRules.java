package org.toqa.cooperation;

/**
 * What the supervisor goes by.
 *
 * @param loadThreshold kilograms up to which one worker carries a box alone
 * @param lowBattery a robot charges when its battery, 0 to 1, is not above this
 * @param workTime seconds of work since it last charged after which a robot charges
 * @param overlaps whether the next box is looked for while others are carried; otherwise only while
 *     all workers wait
 */
public record CarryRules(
    double loadThreshold, double lowBattery, double workTime, boolean overlaps) {

  /** As published: six hours of work. */
  public static final double WORK_TIME = 6 * 3600;

  /** Whether a robot must charge before it does anything new. */
  boolean isLow(double battery, double workSeconds) {
    return battery <= lowBattery || workSeconds >= workTime;
  }
}
