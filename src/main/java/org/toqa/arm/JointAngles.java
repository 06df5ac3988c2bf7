package org.toqa.arm;

/**
 * How the joints of an arm stand, or how fast they turn.
 *
 * @param shoulder radians counter-clockwise from the arm's x axis to its upper link; or a second
 * @param elbow radians counter-clockwise from the upper link's direction to that of the fore link;
 *     or a second
 */
public record JointAngles(double shoulder, double elbow) {

  public static final JointAngles ZERO = new JointAngles(0, 0);

  public JointAngles plus(JointAngles other) {
    return new JointAngles(shoulder + other.shoulder, elbow + other.elbow);
  }

  public JointAngles minus(JointAngles other) {
    return new JointAngles(shoulder - other.shoulder, elbow - other.elbow);
  }

  public JointAngles times(double factor) {
    return new JointAngles(shoulder * factor, elbow * factor);
  }

  /** The larger of the two, without its sign. */
  public double largest() {
    return Math.max(Math.abs(shoulder), Math.abs(elbow));
  }
}
