package org.toqa.formation;

/** How a group can be led, by what the least able of its robots can do; the most able first. */
public enum GroupMobility {
  /** Forward, and straight to either side. */
  SHIFTING(FollowerLawType.OMNI),

  /** Forward only, though its robots can go sideways: one of them does not know shifts. */
  FORWARD(FollowerLawType.OMNI),

  /** Forward only, by a law for robots that cannot go sideways. */
  NON_HOLONOMIC(FollowerLawType.NON_HOLONOMIC);

  private final FollowerLawType law;

  GroupMobility(FollowerLawType law) {
    this.law = law;
  }

  /**
   * That of a robot, or of a group.
   *
   * @param isOmnidirectional whether it can go sideways
   * @param knowsShifts whether it drives and follows segments that do
   */
  public static GroupMobility of(boolean isOmnidirectional, boolean knowsShifts) {
    if (!isOmnidirectional) {
      return NON_HOLONOMIC;
    }
    return knowsShifts ? SHIFTING : FORWARD;
  }

  /** The law that asks the most, of those that its robots follow by. */
  public FollowerLawType law() {
    return law;
  }

  public boolean canShift() {
    return this == SHIFTING;
  }
}
