package org.toqa.app.bench;

import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.MoveSet;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Scenario;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.databind.json.JsonMapper;

/** {@code toqa bench scen}: one way for each query of a scenario file. */
@Command(
    name = "scen",
    description = "Plans one way for each query of a MovingAI scenario file.",
    footer = {
      "",
      "JSON: queries, solved, mismatches, turnsOnSpot (ways that turn on the spot),",
      "nodesPerSecond (states expanded), and the time of a query: meanMicros,",
      "p50Micros, p99Micros, maxMicros. Before they are timed, the queries run up",
      "to 20 times, in all for at most 3 s.",
      "",
      "A mismatch is a way that breaks a rule, or whose length is not the file's",
      "optimal one (within 1e-4 of it), or that was not found. The file's lengths",
      "are octile ones: with --moves heading only a length below them is a",
      "mismatch, since such ways may be longer. Mismatches are named on standard",
      "error, and the command exits 1."
    })
final class ScenarioBench implements Callable<Integer> {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--map",
      required = true,
      paramLabel = "FILE",
      description = "A MovingAI map, or the yaml file of a map_server pair.")
  private Path map = Path.of("");

  @Option(
      names = "--scen",
      required = true,
      paramLabel = "FILE",
      description = "A MovingAI scenario file for the map.")
  private Path scen = Path.of("");

  @Option(
      names = "--moves",
      defaultValue = "octile",
      paramLabel = "octile|heading",
      converter = MoveSet.Converter.class,
      description = "Any of eight moves, or what a robot drives in arcs (default: octile).")
  private MoveSet moves = MoveSet.OCTILE;

  @Option(names = "--limit", paramLabel = "N", description = "Only the first N queries.")
  private @Nullable Integer limit;

  @Option(
      names = "--lengths",
      paramLabel = "FILE",
      description = "Writes the lengths found, in cells, one a line; -1 where there is no way.")
  private @Nullable Path lengths;

  @Override
  public Integer call() throws IOException {
    Arguments arguments = new Arguments(spec);
    if (limit != null) {
      arguments.requireBetween("--limit", limit, 1, Integer.MAX_VALUE);
    }
    if (lengths != null) {
      arguments.requireWritable(lengths);
    }
    OccupancyGrid grid = arguments.readGrid(map);
    List<Scenario> queries = arguments.readScenarios(scen, grid);
    ScenarioRun run =
        new ScenarioRun(
            grid,
            limit == null ? queries : queries.stream().limit(limit).toList(),
            moves,
            sentence -> spec.commandLine().getErr().println("toqa: " + sentence));
    ScenarioRun.Report report = run.measure();
    if (lengths != null) {
      Files.writeString(
          lengths, run.lengths().mapToObj(ScenarioBench::text).collect(joining("\n", "", "\n")));
    }
    spec.commandLine().getOut().println(JsonMapper.shared().writeValueAsString(report));
    return report.mismatches() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private static String text(double length) {
    return length < 0 ? "-1" : Double.toString(length);
  }
}
