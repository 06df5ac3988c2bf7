package org.toqa.traffic.floor;

import org.toqa.motion.Trajectory;

/**
 * How far robots keep apart: so that two that are each as far beside their paths as a daemon lets
 * them be do not touch. Robots that stand nearer to each other may part, but never come nearer.
 */
final class Clearance {
  /** Between the edges of two robots, metres: twice what one may be beside its path. */
  static final double BETWEEN_ROBOTS = 2 * Trajectory.MAX_DEVIATION;

  /**
   * So near two robots never come that both keep to their paths, metres between their edges: the
   * safety distance Ds of CMCT.
   */
  static final double LEAST = BETWEEN_ROBOTS - Trajectory.MAX_DEVIATION;

  private static final double ROUNDING = 1e-6;

  private Clearance() {}

  /** Whether two areas are as far apart as robots keep. */
  static boolean isKept(SweptArea area, SweptArea other) {
    return area.gapTo(other, BETWEEN_ROBOTS) >= BETWEEN_ROBOTS - ROUNDING;
  }

  /**
   * How far a robot that sets out has to keep from another's area, metres.
   *
   * @param standing what it covers where it sets out
   */
  static double needed(SweptArea standing, SweptArea other) {
    return standing.gapTo(other, BETWEEN_ROBOTS);
  }

  /**
   * Whether who drives over an area comes too near to another one, and nearer than it is.
   *
   * @param standing what it covers where it is
   */
  static boolean isBroken(SweptArea standing, SweptArea area, SweptArea other) {
    return area.gapTo(other, LEAST) < standing.gapTo(other, LEAST) - ROUNDING;
  }

  /**
   * Whether a robot can go over an area, as far as another's is concerned.
   *
   * @param standing what it covers where it sets out
   */
  static boolean isKept(SweptArea standing, SweptArea area, SweptArea other) {
    return isKept(area, other)
        || area.gapTo(other, BETWEEN_ROBOTS) >= needed(standing, other) - ROUNDING;
  }
}
