package org.toqa.arm;

/** Why an arm did not do what it was told. */
public enum ArmFailure {
  /** The place is farther than the links are long, where the robot stands. */
  TOO_FAR,
  /** The place is too near to the shoulder. */
  TOO_NEAR,
  /** The joints cannot turn so. */
  JOINT_LIMITS,
  /** Nothing was in the hand after it had closed. */
  NOTHING_GRASPED,
  /** It was to place what it does not hold. */
  NOTHING_HELD,
  /** It was to pick up, and holds something. */
  HAND_FULL,
  /** What it grasped weighs more than it may lift; it let go of it. */
  TOO_HEAVY,
  /** The load hangs on the hand that has opened. */
  NOT_RELEASED,
  /** The joints do not follow. */
  STALLED;

  /** As what the place is out of reach for. */
  public static ArmFailure of(Reach.Reason reason) {
    return switch (reason) {
      case TOO_FAR -> TOO_FAR;
      case TOO_NEAR -> TOO_NEAR;
      case JOINT_LIMITS -> JOINT_LIMITS;
    };
  }
}
