package org.toqa.formation;

import org.toqa.motion.DriveKind;

/** The follower laws, by the words for them in a robot's configuration. */
public enum FollowerLawType {
  OMNI("omni"),
  NON_HOLONOMIC("non-holonomic");

  private final String word;

  FollowerLawType(String word) {
    this.word = word;
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

  public FollowerLaw withGains(Gains gains) {
    return switch (this) {
      case OMNI -> new SingleIntegratorLaw(gains);
      case NON_HOLONOMIC -> new NonHolonomicLaw(gains);
    };
  }
}
