package org.toqa.app.command;

import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** {@code --port}: where the web pages are served. */
public final class PortOption {
  @Option(
      names = "--port",
      paramLabel = "P",
      description = "Port of the web pages; 0 takes any free port (default: 8080).")
  private @Nullable String port;

  /** As it was typed, not checked; null where none is given. */
  public @Nullable String value() {
    return port;
  }
}
