package org.toqa.formation;

import org.toqa.motion.DriveKind;

/** The follower laws, by the words for them in a robot's configuration, and what they need. */
public enum FollowerLawType {
  OMNI("omni", 0.05, 1, 0, Double.POSITIVE_INFINITY),

  /** On an arc its robots must face across the leader's heading, the more the tighter it is. */
  NON_HOLONOMIC("non-holonomic", 0.1, 2.5, 2.2, 0.12);

  private final String word;
  private final double tolerance;
  private final double roundness;
  private final double lengthFactor;
  private final double mostSpeed;

  FollowerLawType(
      String word, double tolerance, double roundness, double lengthFactor, double mostSpeed) {
    this.word = word;
    this.tolerance = tolerance;
    this.roundness = roundness;
    this.lengthFactor = lengthFactor;
    this.mostSpeed = mostSpeed;
  }

  /** The law for robots of a kind. */
  public static FollowerLawType of(DriveKind kind) {
    return switch (kind) {
      case OMNI -> OMNI;
      case DIFFERENTIAL -> NON_HOLONOMIC;
    };
  }

  public String word() {
    return word;
  }

  /** Metres that a follower may be off its place. */
  public double tolerance() {
    return tolerance;
  }

  /** How many times as wide as omnidirectional robots need them corners are at least. */
  public double roundness() {
    return roundness;
  }

  /**
   * Metres of a corner's radius, at least, for each metre that a follower is before or behind its
   * leader: 1 / tan of the angle by which it faces across the leader's heading there.
   */
  public double lengthFactor() {
    return lengthFactor;
  }

  /** Metres a second at most, of each robot of the group. */
  public double mostSpeed() {
    return mostSpeed;
  }

  public FollowerLaw withGains(Gains gains) {
    return switch (this) {
      case OMNI -> new SingleIntegratorLaw(gains);
      case NON_HOLONOMIC -> new NonHolonomicLaw(gains);
    };
  }
}
