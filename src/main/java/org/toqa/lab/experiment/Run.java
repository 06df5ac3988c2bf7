package org.toqa.lab.experiment;

import java.util.HashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;

/**
 * What an experiment is given.
 *
 * @param seed of all random numbers
 * @param runs how often what depends on chance is repeated, at least 1
 * @param values of parameters that were set, by name
 * @param listener is told how far the run is
 * @param isStopped whether the run is to end early; any thread may change its answer
 */
public record Run(
    long seed,
    int runs,
    Map<String, Double> values,
    ProgressListener listener,
    BooleanSupplier isStopped) {

  /** More runs of an experiment are not begun. */
  public static final int MOST_RUNS = 10_000;

  /** Hears how far a run is. */
  public interface ProgressListener {
    /**
     * @param share done, 0 to 1
     * @param step what is done next, for a person
     */
    void progress(double share, String step);
  }

  /**
   * @throws IllegalArgumentException if there is no run
   */
  public Run {
    if (runs < 1) {
      throw new IllegalArgumentException("An experiment has at least one run, not " + runs + ".");
    }
    values = Map.copyOf(values);
  }

  /** A run that nobody watches or stops, with all parameters as they are. */
  public static Run of(long seed, int runs) {
    return new Run(seed, runs, Map.of(), (share, step) -> {}, () -> false);
  }

  /**
   * The seed of one of the runs; each has the next one.
   *
   * @param index from 0
   */
  public long seedOf(int index) {
    return seed + index;
  }

  /** What a parameter was set to, or its value. */
  public double value(Parameter parameter) {
    return values.getOrDefault(parameter.name(), parameter.value());
  }

  /** The same run with another value of a parameter, as to see how much depends on it. */
  public Run with(Parameter parameter, double value) {
    Map<String, Double> changed = new HashMap<>(values);
    changed.put(parameter.name(), value);
    return new Run(seed, runs, changed, listener, isStopped);
  }

  /**
   * Tells how far the run is.
   *
   * @param share done, 0 to 1
   * @param step what is done next, for a person
   * @throws RunStoppedException the run is to end early
   */
  public void progress(double share, String step) {
    checkStopped();
    listener.progress(share, step);
  }

  /**
   * Is called wherever a while has passed, so that a run ends within a second of being stopped.
   *
   * @throws RunStoppedException the run is to end early
   */
  public void checkStopped() {
    if (isStopped.getAsBoolean()) {
      throw new RunStoppedException();
    }
  }
}
