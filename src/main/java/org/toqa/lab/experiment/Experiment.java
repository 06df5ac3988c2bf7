package org.toqa.lab.experiment;

import java.util.List;

/**
 * A published experiment that is done again with what Toqa implements.
 *
 * <p>An experiment is a function of its {@link Run}: the same seed, number of runs and values of
 * parameters give the same report, but for figures that are times of this machine. It keeps
 * nothing, and any thread may run it.
 *
 * <ol>
 *   <li>Its {@link #parameters} are what the paper leaves open, with the values that were chosen
 *       before any result was looked at.
 *   <li>{@link #run} is called once. It tells its progress to the run, which throws when the run is
 *       to end early.
 *   <li>It answers with every published figure beside the measured one.
 * </ol>
 */
public interface Experiment {
  /** By which it is asked for: lower-case words with hyphens, such as {@code csm-static}. */
  String name();

  /** What it does, in one line. */
  String title();

  /** Where it was published: system, authors or year, and the tables and figures. */
  String source();

  /** What may be set; a run without values has their defaults. */
  List<Parameter> parameters();

  /**
   * Does it.
   *
   * @throws RunStoppedException the run was to end early
   */
  Report run(Run run);
}
