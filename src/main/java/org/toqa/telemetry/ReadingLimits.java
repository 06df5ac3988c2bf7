package org.toqa.telemetry;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Between which a reading of a robot is as it should be.
 *
 * @param low null: it has no limit there
 * @param high null: it has no limit there
 */
public record ReadingLimits(
    String robot, String reading, @Nullable Double low, @Nullable Double high) {

  /** Whether there is no limit. */
  public boolean isNone() {
    return low == null && high == null;
  }

  /** What is wrong with it; empty: it is within. */
  Optional<Sentence> violation(Reading measured) {
    String unit = measured.unit().isEmpty() ? "" : " " + measured.unit();
    if (low != null && measured.least() < low) {
      return Optional.of(Phrase.READING_BELOW.with(measured.name(), measured.least(), unit, low));
    }
    if (high != null && measured.greatest() > high) {
      return Optional.of(
          Phrase.READING_ABOVE.with(measured.name(), measured.greatest(), unit, high));
    }
    return Optional.empty();
  }
}
