package org.toqa.agent.drive;

/**
 * How abruptly the velocity of a reference may change.
 *
 * @param acceleration metres a second squared
 * @param turnAcceleration radians a second squared
 * @param speedJump metres a second, at once, between two segments
 * @param turnRateJump radians a second, likewise
 */
public record PaceLimits(
    double acceleration, double turnAcceleration, double speedJump, double turnRateJump) {

  /** Of any robot of a group: between two poses of the leader no follower knows of a change. */
  private static final double GROUP_ACCELERATION = 0.2;

  private static final double GROUP_JUMP = 0.05;

  /** Stops a robot from 0.25 m/s in 0.17 s; three wheels do 1.7. */
  private static final double BRAKING = 1.5;

  private static final double TURN_BRAKING = 6;

  /** For a robot alone; the jumps are what motors and tracking can follow. */
  public static PaceLimits forSingleRobot(MotionLimits limits) {
    return new PaceLimits(limits.acceleration(), limits.turnAcceleration(), 0.15, 0.8);
  }

  /**
   * For the leader of a group.
   *
   * @param reach metres to the follower that is farthest from it, which a turn moves most
   */
  public static PaceLimits forLeader(MotionLimits limits, double reach) {
    return new PaceLimits(
        Math.min(limits.acceleration(), GROUP_ACCELERATION),
        Math.min(limits.turnAcceleration(), GROUP_ACCELERATION / reach),
        GROUP_JUMP,
        GROUP_JUMP / reach);
  }

  /** The same, but it stops as fast as wheels can. */
  public PaceLimits withBraking() {
    return new PaceLimits(BRAKING, TURN_BRAKING, speedJump, turnRateJump);
  }
}
