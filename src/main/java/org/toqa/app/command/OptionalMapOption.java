package org.toqa.app.command;

import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** {@code --map} of a command that takes the shipped map where none is named. */
public final class OptionalMapOption {
  @Option(
      names = "--map",
      paramLabel = "FILE",
      description =
          "Map: the .yaml file of a ROS map_server pair, or a MovingAI .map file (default: the"
              + " shipped map).")
  private @Nullable String file;

  /** The file as it was typed, not checked; null where none is named. */
  public @Nullable String file() {
    return file;
  }
}
