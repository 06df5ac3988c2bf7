package org.toqa.formation;

import java.util.function.Function;

/** The follower laws, by the words for them in a robot's configuration. */
public enum FollowerLawType {
  OMNI("omni", SingleIntegratorLaw::new),
  NON_HOLONOMIC("non-holonomic", NonHolonomicLaw::new);

  private final String word;
  private final Function<Gains, FollowerLaw> constructor;

  FollowerLawType(String word, Function<Gains, FollowerLaw> constructor) {
    this.word = word;
    this.constructor = constructor;
  }

  public String word() {
    return word;
  }

  public FollowerLaw withGains(Gains gains) {
    return constructor.apply(gains);
  }
}
