package org.toqa.formation;

/**
 * How firmly a robot is drawn to the place where it should be.
 *
 * <p>A gain k makes an error fade with the time constant 1/k. Through a body that obeys after a lag
 * T the loop is stable while k T is below pi/2, and does not swing while it is below 1/e; robots'
 * motors and ticks make T about 0.08 s. Hence the upper bound, which keeps k T below 0.4. The
 * seed's dead-beat gain of one error a time step (50 a second) is far above it.
 *
 * @param place 1/s
 * @param heading 1/s
 * @param mostSpeed metres a second: no error, however large, is corrected faster
 * @param mostTurnRate radians a second, likewise
 */
public record Gains(double place, double heading, double mostSpeed, double mostTurnRate) {

  public static final double LARGEST = 5;

  public static final double SMALLEST = 0.1;

  public static final Gains DEFAULT = new Gains(2, 3, 0.1, 0.5);

  /**
   * @throws IllegalArgumentException if one is out of its range
   */
  public Gains {
    require("place", place, SMALLEST, LARGEST);
    require("heading", heading, SMALLEST, LARGEST);
    require("mostSpeed", mostSpeed, 0.01, 1);
    require("mostTurnRate", mostTurnRate, 0.01, 5);
  }

  private static void require(String name, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
      throw new IllegalArgumentException(
          "The gain '%s' must be from %s to %s, not %s.".formatted(name, least, most, value));
    }
  }
}
