package org.toqa.app.bench;

import org.toqa.app.command.Arguments;
import picocli.CommandLine.Option;

/** The options of a bench that say how long it measures. */
final class MeasuringTime {
  @Option(
      names = "--seconds",
      defaultValue = "60",
      paramLabel = "S",
      description = "How long it is measured, 1 to 3600 (default: ${DEFAULT-VALUE}).")
  private int seconds;

  @Option(
      names = "--warm-up",
      defaultValue = "30",
      paramLabel = "S",
      description = "How long it runs before that, 0 to 3600 (default: ${DEFAULT-VALUE}).")
  private int warmUp;

  /**
   * @throws picocli.CommandLine.ParameterException when one of them is out of its range
   */
  void check(Arguments arguments) {
    arguments.requireBetween("--seconds", seconds, 1, 3600);
    arguments.requireBetween("--warm-up", warmUp, 0, 3600);
  }

  /** Seconds that are measured. */
  int seconds() {
    return seconds;
  }

  /** Seconds before that. */
  int warmUp() {
    return warmUp;
  }
}
