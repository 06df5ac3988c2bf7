package org.toqa.app.bench.meter;

import org.toqa.app.command.Arguments;
import picocli.CommandLine.Option;

/** {@code --seconds}: how long a bench measures. */
public final class MeasuredSeconds {
  @Option(
      names = "--seconds",
      defaultValue = "60",
      paramLabel = "S",
      description = "Seconds to measure, 1 to 3600 (default: ${DEFAULT-VALUE}).")
  private int seconds;

  /**
   * @throws picocli.CommandLine.ParameterException when it is out of its range
   */
  public void check(Arguments arguments) {
    arguments.requireBetween("--seconds", seconds, 1, 3600);
  }

  /** Seconds of real time. */
  public int value() {
    return seconds;
  }
}
