package org.toqa.motion;

/**
 * What the wheels of a robot with two of them are told for one sample of 30 ms (CSM-MAMRS,
 * "Velocity planner").
 *
 * @param time seconds from the start of the drive
 * @param v metres a second, forward
 * @param w radians a second, counter-clockwise
 */
public record WheelCommand(double time, double v, double w, Wheel left, Wheel right) {
  /** Seconds. */
  public static final double SAMPLE = 0.030;

  /**
   * The signal of one wheel.
   *
   * @param speed metres a second, positive forward
   * @param onSeconds T_on of each period of the pulse width modulation, seconds
   * @param amplitude ISPA, 0 to 255
   * @param pulseMilliseconds at most 33, as the paper has it
   * @param isForward the direction that is sent beside the amplitude
   */
  public record Wheel(
      double speed, double onSeconds, int amplitude, double pulseMilliseconds, boolean isForward) {
    private static final int MOST_AMPLITUDE = 255;
    private static final double LONGEST_PULSE = 33;

    /** Seconds of a period of the modulation: a sample. */
    private static final double PERIOD = SAMPLE;

    /**
     * @param fastest metres a second of which the amplitude is 255
     */
    static Wheel of(double speed, double fastest) {
      // T_on = T_pwm v / v_max, ISPA = 255 v / v_max, pulse = ISPA 33 ms / 255   (CSM-MAMRS)
      double share = Math.min(1, Math.abs(speed) / fastest);
      int amplitude = (int) Math.round(MOST_AMPLITUDE * share);
      return new Wheel(
          speed, PERIOD * share, amplitude, amplitude * LONGEST_PULSE / MOST_AMPLITUDE, speed >= 0);
    }
  }

  /**
   * By inverse kinematics; where a wheel would be faster than its limit, both are slower by the
   * same factor.
   *
   * @param time seconds from the start of the drive
   * @param v metres a second, forward
   * @param w radians a second, counter-clockwise
   */
  public static WheelCommand of(double time, double v, double w, DifferentialLimits limits) {
    // vR = (2 v + L w) / 2, vL = (2 v - L w) / 2
    double turning = w * limits.track() / 2;
    double largest = Math.abs(v) + Math.abs(turning);
    double factor = largest > limits.wheelSpeed() ? limits.wheelSpeed() / largest : 1;
    return new WheelCommand(
        time,
        v * factor,
        w * factor,
        Wheel.of((v - turning) * factor, limits.wheelSpeed()),
        Wheel.of((v + turning) * factor, limits.wheelSpeed()));
  }
}
