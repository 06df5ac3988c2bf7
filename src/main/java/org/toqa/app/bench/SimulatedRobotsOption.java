package org.toqa.app.bench;

import org.toqa.app.command.Arguments;
import picocli.CommandLine.Option;

/** {@code --robots} of a bench that runs a complete server. */
final class SimulatedRobotsOption {
  private static final int MAX_ROBOTS = 500;

  private final int minRobots;

  @Option(
      names = "--robots",
      paramLabel = "N",
      description =
          "Number of simulated robots, at most " + MAX_ROBOTS + " (default: ${DEFAULT-VALUE}).")
  private int robots;

  /**
   * @param defaultRobots where the option is not given
   * @param minRobots the fewest that the bench can use
   */
  SimulatedRobotsOption(int defaultRobots, int minRobots) {
    robots = defaultRobots;
    this.minRobots = minRobots;
  }

  /**
   * @throws picocli.CommandLine.ParameterException when it is out of its range
   */
  void check(Arguments arguments) {
    arguments.requireBetween("--robots", robots, minRobots, MAX_ROBOTS);
  }

  int value() {
    return robots;
  }
}
