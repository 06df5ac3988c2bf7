package org.toqa.arm;

import java.util.List;

/** Whether an arm comes to a place. */
public sealed interface Reach {

  /**
   * It does.
   *
   * @param ways how its joints stand then: one or two, each within their limits
   */
  record Within(List<JointAngles> ways) implements Reach {
    public Within {
      ways = List.copyOf(ways);
    }
  }

  /**
   * It does not.
   *
   * @param distance metres from the shoulder to the place
   */
  record Outside(Reason reason, double distance) implements Reach {}

  enum Reason {
    /** The place is farther from the shoulder than both links together are long. */
    TOO_FAR,
    /** The place is nearer to the shoulder than the links' lengths differ. */
    TOO_NEAR,
    /** The joints cannot turn so. */
    JOINT_LIMITS
  }
}
