package org.toqa.app.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.toqa.app.bench.meter.MeasuredSeconds;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.TemporaryFolder;
import org.toqa.motion.WheelCommand;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code ./toqa bench http}: how fast robots that take wheel commands over HTTP are driven. */
@Command(
    name = "http",
    description = "Measure how fast robots are driven that take wheel commands over HTTP.",
    footer = {
      "",
      "For each number of robots, all of them drive round circles for S seconds, in",
      "this process: their daemons, as a server runs them, and the robots with their",
      "simulated bodies, over TCP on loopback.",
      "",
      "Prints JSON: in levels for each number robots, exchange (from the command to",
      "its answer), exchangesPerSecond of each robot, failed (exchanges without an",
      "answer), core (processor seconds per second, of daemons and robots together);",
      "and mostWithin30Ms, the largest of the numbers, as far as all smaller ones",
      "do too, with which 99 of 100 exchanges take 30 ms at most, and none fails."
    })
final class HttpBench implements Callable<Integer> {
  private static final double LIMIT_MS = WheelCommand.SAMPLE * 1000;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private MeasuredSeconds seconds = new MeasuredSeconds();

  @Option(
      names = "--robots",
      split = ",",
      defaultValue = "3",
      paramLabel = "N[,N...]",
      description = "Numbers of robots, each 1 to 500 (default: ${DEFAULT-VALUE}).")
  private List<Integer> robots = List.of();

  /**
   * @param mostWithin30Ms 0: none
   */
  private record Report(int mostWithin30Ms, List<HttpRobotsRun.Level> levels) {}

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    seconds.check(arguments);
    for (int number : robots) {
      arguments.requireBetween("--robots", number, 1, 500);
    }
    List<HttpRobotsRun.Level> levels = new ArrayList<>();
    for (int number : robots.stream().sorted().toList()) {
      try (TemporaryFolder folder = TemporaryFolder.create("toqa-bench")) {
        levels.add(measure(number, folder.path()));
      }
    }
    new BenchOutput(spec).printReport(new Report(mostWithinLimit(levels), levels));
    return ExitCode.OK;
  }

  private HttpRobotsRun.Level measure(int number, Path folder) throws Exception {
    try (HttpRobotsRun run = HttpRobotsRun.start(number, folder)) {
      return run.measure(seconds.value());
    }
  }

  private static int mostWithinLimit(List<HttpRobotsRun.Level> levels) {
    int most = 0;
    for (HttpRobotsRun.Level level : levels) {
      if (level.exchange().p99Ms() > LIMIT_MS || level.failed() > 0) {
        return most;
      }
      most = level.robots();
    }
    return most;
  }
}
