package org.toqa.app.bench;

import java.time.Duration;
import picocli.CommandLine.Option;

/** How robots' agents answer in negotiations: {@code --silent}, {@code --slow-bidders}. */
final class BidderFaults {
  @Option(
      names = "--silent",
      defaultValue = "0",
      paramLabel = "N",
      description =
          "contract-net: number of robots that never answer, from the last one on"
              + " (default: ${DEFAULT-VALUE}).")
  int silent;

  @Option(
      names = "--slow-bidders",
      defaultValue = "0",
      paramLabel = "N",
      description =
          "contract-net: number of robots that answer late, from the first one on"
              + " (default: ${DEFAULT-VALUE}).")
  int slow;

  @Option(
      names = "--bidder-delay",
      defaultValue = "800",
      paramLabel = "MS",
      description =
          "contract-net: how late these answer, 0 to 10000; more than 1000 is too late"
              + " (default: ${DEFAULT-VALUE}).")
  int delay;

  /**
   * @param index of the robot
   * @param robots how many there are
   */
  boolean isSilent(int index, int robots) {
    return index >= robots - silent;
  }

  Duration delay(int index) {
    return index < slow ? Duration.ofMillis(delay) : Duration.ZERO;
  }
}
