package org.toqa.app.command;

import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** {@code --speed}: how fast simulated time passes. */
public final class SpeedOption {
  @Option(
      names = "--speed",
      paramLabel = "N",
      description = "Run simulated time N times faster than real time (default: 1).")
  private @Nullable String speed;

  /** A multiple of real time as it was typed, not checked; null where none is given. */
  public @Nullable String value() {
    return speed;
  }
}
