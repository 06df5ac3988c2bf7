package org.toqa.app.command;

import picocli.CommandLine.Option;

/** {@code --seed}: the same seed and the same arguments give the same random numbers. */
public final class SeedOption {
  @Option(
      names = "--seed",
      defaultValue = "1",
      paramLabel = "S",
      description = "Seed of the random numbers (default: ${DEFAULT-VALUE}).")
  private long seed;

  /** Any whole number. */
  public long value() {
    return seed;
  }
}
