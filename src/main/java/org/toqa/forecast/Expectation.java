package org.toqa.forecast;

import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/**
 * When a task will be where.
 *
 * @param pickUp seconds until its load is on board; empty: it is, or that cannot be said
 * @param delivery seconds until it is delivered; empty: that cannot be said
 * @param unknown why something cannot be said; null: nothing is missing
 */
public record Expectation(
    OptionalDouble pickUp, OptionalDouble delivery, @Nullable Unknown unknown) {

  /** Nothing can be said. */
  public static Expectation none(Unknown why) {
    return new Expectation(OptionalDouble.empty(), OptionalDouble.empty(), why);
  }
}
