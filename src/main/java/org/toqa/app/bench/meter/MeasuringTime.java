package org.toqa.app.bench.meter;

import org.toqa.app.command.Arguments;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of a bench that say how long it measures, and how long it warms up before. */
public final class MeasuringTime {
  @Mixin private MeasuredSeconds measured = new MeasuredSeconds();

  @Option(
      names = "--warm-up",
      defaultValue = "30",
      paramLabel = "S",
      description = "Seconds to run before measuring, 0 to 3600 (default: ${DEFAULT-VALUE}).")
  private int warmUp;

  /**
   * @throws picocli.CommandLine.ParameterException when one of them is out of its range
   */
  public void check(Arguments arguments) {
    measured.check(arguments);
    arguments.requireBetween("--warm-up", warmUp, 0, 3600);
  }

  /** Seconds of real time that are measured. */
  public int seconds() {
    return measured.value();
  }

  /** Seconds of real time before that. */
  public int warmUp() {
    return warmUp;
  }
}
