package org.toqa.avoidance.fouragents;

import java.util.List;

/**
 * How much each agent wants to drive, 0 to 1.
 *
 * @param navigation 1 nearer to the target than the arrival distance
 * @param staticAvoidance 1 on and inside the convergence circle of what is on the way
 * @param dynamicAvoidance the larger the nearer and the farther ahead something unknown is
 */
public record Utilities(double navigation, double staticAvoidance, double dynamicAvoidance) {

  /** Radians from the heading, up to which an obstacle counts as ahead in full. */
  private static final double AHEAD = Math.toRadians(90);

  public double of(DrivingAgent agent) {
    return switch (agent) {
      case NAVIGATION -> navigation;
      case STATIC_AVOIDANCE -> staticAvoidance;
      case DYNAMIC_AVOIDANCE -> dynamicAvoidance;
    };
  }

  /**
   * Who drives: the one with the highest utility; the present one as long as no other has more by
   * the hysteresis. A more careful agent of full utility drives at once: in the seed navigation
   * near the target has the most that there is, and would drive into what is there.
   */
  DrivingAgent choose(DrivingAgent present, double hysteresis) {
    DrivingAgent best = present;
    for (DrivingAgent agent : DrivingAgent.values()) {
      boolean isMore = of(agent) > of(best);
      boolean isCareful = of(agent) == of(best) && agent.compareTo(best) < 0 && of(agent) > 0;
      if (isMore || isCareful) {
        best = agent;
      }
    }
    boolean isUrgent = best.compareTo(present) < 0 && of(best) >= 1;
    return isUrgent || of(best) > of(present) + hysteresis ? best : present;
  }

  /**
   * Of navigation: 1 up to the arrival distance, down to {@code cruise} at twice that.
   *
   * @param distance metres to the target
   */
  static double navigation(double distance, double arrival, double cruise) {
    return cruise + (1 - cruise) * Math.clamp(2 - distance / arrival, 0, 1);
  }

  /**
   * Of static avoidance: 1 on the convergence circle and inside; without a rise, as the seed has
   * it, 0 on the circle and 1 where the margin is used up.
   *
   * @param outside metres from the circle outward; negative inside
   */
  static double staticAvoidance(double outside, double approach, double margin) {
    return approach > 0
        ? Math.clamp(1 - outside / approach, 0, 1)
        : Math.clamp(-outside / margin, 0, 1);
  }

  /**
   * Of dynamic avoidance: the largest over the sensors of distance utility (0 from the dangerous
   * zone outward, 1 from its half inward) times angle utility (1 up to 90 degrees, 0 behind).
   */
  static double dynamicAvoidance(List<Double> unknown, double danger) {
    double most = 0;
    for (int i = 0; i < RangeRing.SIZE; i++) {
      double near = Math.clamp(2 * (1 - unknown.get(i) / danger), 0, 1);
      double angle = Math.abs(RangeRing.DIRECTIONS.get(i));
      double ahead = Math.clamp((Math.PI - angle) / (Math.PI - AHEAD), 0, 1);
      most = Math.max(most, near * ahead);
    }
    return most;
  }
}
