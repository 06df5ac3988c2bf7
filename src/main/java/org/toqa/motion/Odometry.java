package org.toqa.motion;

import org.toqa.geometry.Pose;

/**
 * A robot's pose from its wheels' encoder counts: each step is taken as an arc of constant
 * velocity. Confined to one thread.
 */
public final class Odometry {
  /** Gear 1:27, 26 pulses a motor turn, quadrature times 4. */
  public static final int COUNTS_PER_WHEEL_TURN = 27 * 26 * 4;

  private final WheelKinematics kinematics;
  private final int countsPerTurn;
  private int[] last;
  private Pose pose;

  /**
   * @param countsPerTurn encoder counts of one turn of a wheel
   * @param pose where the robot is, map frame
   * @param counts what the wheels' 32-bit counters say there
   * @throws IllegalArgumentException if there is no count a turn, or not one counter a wheel
   */
  public Odometry(WheelKinematics kinematics, int countsPerTurn, Pose pose, int... counts) {
    if (countsPerTurn < 1) {
      throw new IllegalArgumentException(
          "A wheel's turn has at least one count, not " + countsPerTurn + ".");
    }
    this.kinematics = kinematics;
    this.countsPerTurn = countsPerTurn;
    this.pose = pose;
    this.last = checked(counts);
  }

  /** Where the robot was at the last update, map frame. */
  public Pose pose() {
    return pose;
  }

  /** Corrects where the robot is, map frame. */
  public void setPose(Pose newPose) {
    pose = newPose;
  }

  /**
   * The pose now, map frame.
   *
   * @param counts of each wheel; a counter may have wrapped around since the last call
   * @throws IllegalArgumentException if there is not one count a wheel
   */
  public Pose update(int... counts) {
    checked(counts);
    // as if the step had taken a second
    WheelSpeeds turned =
        WheelSpeeds.of(
            counts.length, wheel -> (counts[wheel] - last[wheel]) * 2 * Math.PI / countsPerTurn);
    last = counts.clone();
    pose = pose.advanced(kinematics.twist(turned), 1);
    return pose;
  }

  private int[] checked(int[] counts) {
    if (counts.length != kinematics.wheelCount()) {
      throw new IllegalArgumentException(
          "Expected counts of " + kinematics.wheelCount() + " wheels, not " + counts.length + ".");
    }
    return counts.clone();
  }
}
