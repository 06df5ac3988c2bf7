package org.toqa.app.bench;

import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.MoveSet;
import org.toqa.app.command.MovesOption;
import org.toqa.app.command.RequiredMapOption;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Scenario;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench scen}: one path for each query of a scenario file. */
@Command(
    name = "scen",
    description = "Plan one path for each query of a MovingAI scenario.",
    footer = {
      "",
      "Prints JSON: queries, solved, mismatches, turnsOnSpot (paths that turn on the",
      "spot), nodesPerSecond (states expanded), and the time of a query: meanMicros,",
      "p50Micros, p99Micros, maxMicros. Before they are timed, the queries run up to",
      "20 times, for at most 3 s in all.",
      "",
      "A mismatch is a path that breaks a rule, a path whose length is not the optimal",
      "one of the file (tolerance 1e-4), or a path that was not found. The lengths in",
      "the file are octile: with --moves heading only a shorter path is a mismatch.",
      "Mismatches are listed on standard error, and the command exits 1."
    })
final class ScenarioBench implements Callable<Integer> {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private RequiredMapOption map = new RequiredMapOption();

  @Option(
      names = "--scen",
      required = true,
      paramLabel = "FILE",
      description = "MovingAI scenario file for the map.")
  private Path scen = Path.of("");

  @Mixin private MovesOption moves = new MovesOption(MoveSet.OCTILE);

  @Option(names = "--limit", paramLabel = "N", description = "Run only the first N queries.")
  private @Nullable Integer limit;

  @Option(
      names = "--lengths",
      paramLabel = "FILE",
      description =
          "Write the path lengths to FILE, in cells, one per line; -1 if there is no path.")
  private @Nullable Path lengths;

  @Override
  public Integer call() throws IOException {
    Arguments arguments = new Arguments(spec);
    CommandOutput output = new CommandOutput(spec);
    if (limit != null) {
      arguments.requireBetween("--limit", limit, 1, Integer.MAX_VALUE);
    }
    if (lengths != null) {
      arguments.requireWritable(lengths);
    }
    OccupancyGrid grid = arguments.readGrid(map.file());
    List<Scenario> queries = arguments.readScenarios(scen, grid);
    ScenarioRun run =
        new ScenarioRun(
            grid,
            limit == null ? queries : queries.stream().limit(limit).toList(),
            moves.value(),
            output::printError);
    ScenarioRun.Report report = run.measure();
    if (lengths != null) {
      Files.writeString(
          lengths, run.lengths().mapToObj(ScenarioBench::text).collect(joining("\n", "", "\n")));
    }
    new BenchOutput(spec).printReport(report);
    return report.mismatches() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private static String text(double length) {
    return length < 0 ? "-1" : Double.toString(length);
  }
}
