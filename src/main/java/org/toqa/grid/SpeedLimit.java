package org.toqa.grid;

/**
 * A part of a floor where robots drive slowly.
 *
 * @param speed metres a second, above 0
 */
public record SpeedLimit(Area area, double speed) {
  public SpeedLimit {
    if (!(speed > 0)) {
      throw new IllegalArgumentException("a limit of " + speed + " m/s");
    }
  }
}
