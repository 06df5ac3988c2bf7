package org.toqa.testbed;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Locale;

/**
 * How much is fuzzed: what {@code -Dtoqa.fuzz.inputs} says, for each target, and by which {@code
 * -Dtoqa.seed}.
 */
public final class FuzzRun {

  public static final long INPUTS = Long.getLong("toqa.fuzz.inputs", 10_000);
  public static final long SEED = Long.getLong("toqa.seed", 1);

  private FuzzRun() {}

  /**
   * Tells on standard output what was done, which must be as much as was asked for.
   *
   * @param target who had to take the inputs
   * @param begin of the run, {@link System#nanoTime}
   */
  public static void tell(String target, long inputs, String became, long begin) {
    assertTrue(inputs >= INPUTS, () -> target + " had only " + inputs + " inputs");
    Tally.add("fuzz inputs of " + target, inputs);
    System.out.printf(
        Locale.ROOT,
        "fuzzed %s: %,d inputs of seed %d in %.1f s; %s%n",
        target,
        inputs,
        SEED,
        Duration.ofNanos(System.nanoTime() - begin).toMillis() / 1e3,
        became);
  }
}
