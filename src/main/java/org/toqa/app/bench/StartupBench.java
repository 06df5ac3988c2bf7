package org.toqa.app.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.TemporaryFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench startup}: how long a server takes until it serves. */
@Command(
    name = "startup",
    description = "Measure how long a server takes to start.",
    footer = {
      "",
      "Prints JSON: first (with an empty data folder, in which it makes its database)",
      "and again (with the data of that start), each from the start of the process",
      "until /api/v1/health answers 200."
    })
final class StartupBench implements Callable<Integer> {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--runs",
      defaultValue = "5",
      paramLabel = "N",
      description = "Number of starts of each kind, 1 to 100 (default: ${DEFAULT-VALUE}).")
  private int runs;

  /**
   * @param first starts with an empty data folder
   * @param again starts with the data of the first
   */
  private record Report(int runs, LatencySummary first, LatencySummary again) {}

  @Override
  public Integer call() throws IOException, InterruptedException {
    new Arguments(spec).requireBetween("--runs", runs, 1, 100);
    double[] first = new double[runs];
    double[] again = new double[runs];
    for (int run = 0; run < runs; run++) {
      try (TemporaryFolder data = TemporaryFolder.create("toqa-bench")) {
        first[run] = startMillis(data.path());
        again[run] = startMillis(data.path());
      }
    }
    new BenchOutput(spec)
        .printReport(new Report(runs, LatencySummary.of(first), LatencySummary.of(again)));
    return ExitCode.OK;
  }

  private static double startMillis(Path data) throws IOException, InterruptedException {
    try (MeasuredServer server = MeasuredServer.start(data)) {
      return server.startMillis();
    }
  }
}
