package org.toqa.app.command;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** {@code --map} of a command that cannot do without one. */
public final class RequiredMapOption {
  @Option(
      names = "--map",
      required = true,
      paramLabel = "FILE",
      description = "Map: the .yaml file of a ROS map_server pair, or a MovingAI .map file.")
  private Path file = Path.of("");

  /** The file as it was named, not checked. */
  public Path file() {
    return file;
  }
}
