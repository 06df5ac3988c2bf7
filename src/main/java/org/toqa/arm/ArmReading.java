package org.toqa.arm;

/**
 * An arm as it is.
 *
 * @param angles of its joints, radians
 * @param handClosed whether its hand is closed
 * @param load kilograms that its load sensor feels on the hand; 0: nothing
 * @param stalled whether it says itself that its joints do not follow
 */
public record ArmReading(JointAngles angles, boolean handClosed, double load, boolean stalled) {

  /** Of an arm that does not say whether its joints follow. */
  public ArmReading(JointAngles angles, boolean handClosed, double load) {
    this(angles, handClosed, load, false);
  }

  /** Kilograms: what weighs less is nothing. */
  public static final double LEAST_LOAD = 0.02;

  /** Whether something is in its hand. */
  public boolean isHolding() {
    return handClosed && load >= LEAST_LOAD;
  }
}
