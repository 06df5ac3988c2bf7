package org.toqa.allocation;

import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What it costs that one robot carries a load, or why it does not.
 *
 * @param approach metres to the load; infinite where it is not known
 * @param joules infinite where something speaks against it
 * @param impediment null where nothing does
 * @param reason of the impediment, follows the robot's name in a sentence; null where there is none
 */
public record Quote(
    double approach, double joules, @Nullable Impediment impediment, @Nullable Sentence reason) {

  /** The agent of the robot has not answered in time. */
  static final Quote SILENT = decline(Impediment.SILENT, Phrase.HAS_NOT_ANSWERED.with());

  static Quote possible(double approach, double joules) {
    return new Quote(approach, joules, null, null);
  }

  static Quote impossible(double approach, Impediment impediment, Sentence reason) {
    return new Quote(approach, Double.POSITIVE_INFINITY, impediment, reason);
  }

  /** Nothing was looked at. */
  static Quote decline(Impediment impediment, Sentence reason) {
    return impossible(Double.POSITIVE_INFINITY, impediment, reason);
  }

  public boolean isPossible() {
    return impediment == null;
  }

  /** Whether it is one at all: what a robot's agent says is looked at like what a stranger says. */
  boolean isSound() {
    return impediment == null
        ? Double.isFinite(joules) && joules >= 0 && Double.isFinite(approach) && approach >= 0
        : reason != null;
  }
}
