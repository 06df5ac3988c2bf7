package org.toqa.app.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.PlaceArgument;
import org.toqa.app.command.SeedOption;
import org.toqa.app.command.WordConverter;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.SmoothMethod;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench smooth}: short smooth paths of a disc, against the exact shortest ones. */
@Command(
    name = "smooth",
    description = "Plan smooth paths for a disc and compare them with the shortest ones.",
    footer = {
      "",
      "With --map: plans from --from to --to, once for each repeat. Prints JSON; runs",
      "has for each: found, reason (START_BLOCKED, GOAL_BLOCKED, NO_PATH, OUT_OF_TIME,",
      "or null), length (metres along the curve), shortest (metres, exact, by other",
      "code; null if there is no path), ratio of the two, maxCurvature (radians per",
      "metre), turnsOnSpot, milliseconds, path (points in metres, at most 0.01 m",
      "apart), and progress (iteration and length in metres each time the path became",
      "shorter). Exits 1 if a run finds no path.",
      "",
      "Without a map: random scenes of 2.5 m x 2.5 m with 10 and 50 ms for each path.",
      "Prints JSON: scenes, reachable (scenes with a path), and in limits for each",
      "time limit: limitMs, medianRatio, p95Ratio, maxRatio, failures (no path found",
      "where there is one), touching (paths that touch a wall), medianMilliseconds and",
      "maxMilliseconds. Exits 1 if there is a failure.",
      "",
      "The map's border is wall. Before they are timed, plans run for up to 4 s."
    })
final class SmoothBench implements Callable<Integer> {
  private static final int MOST_MS = 3_600_000;
  private static final int MOST_REPEATS = 10_000;
  private static final int MOST_SCENES = 10_000;
  private static final double SMALLEST_RADIUS = 0.001;
  private static final double LARGEST_RADIUS = 1000;

  /** Of a scene's robot, metres; a larger one hardly fits between its obstacles. */
  private static final double LARGEST_IN_SCENE = 0.2;

  private static final List<Integer> SCENE_LIMITS = List.of(10, 50);

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--map",
      paramLabel = "FILE",
      description =
          "Map: the .yaml file of a ROS map_server pair, or a MovingAI .map file (default: random"
              + " scenes).")
  private @Nullable Path map;

  @Option(
      names = "--from",
      paramLabel = "X,Y",
      converter = PlaceArgument.PointConverter.class,
      description = "Start, metres in the map frame.")
  private @Nullable PlaceArgument from;

  @Option(
      names = "--to",
      paramLabel = "X,Y",
      converter = PlaceArgument.PointConverter.class,
      description = "Goal, metres in the map frame.")
  private @Nullable PlaceArgument to;

  @Option(
      names = "--radius",
      defaultValue = "0.1",
      paramLabel = "M",
      description = "Radius of the disc in metres (default: ${DEFAULT-VALUE}).")
  private double radius;

  @Option(
      names = "--limit-ms",
      paramLabel = "T",
      description = "Time limit of a plan, in milliseconds.")
  private @Nullable Integer limitMs;

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--repeat",
      paramLabel = "N",
      description = "Number of plans; each has the next seed (default: 1).")
  private @Nullable Integer repeat;

  @Option(
      names = "--scenes",
      paramLabel = "N",
      description = "Number of random scenes (default: 100).")
  private @Nullable Integer scenes;

  @Option(
      names = "--method",
      defaultValue = "hybrid",
      paramLabel = "hybrid|rrt-star|particle-swarm",
      converter = MethodConverter.class,
      description = "Planner: both parts, or one alone (default: ${DEFAULT-VALUE}).")
  private SmoothMethod method = SmoothMethod.HYBRID;

  /** Reads what a user types. */
  static final class MethodConverter extends WordConverter<SmoothMethod> {
    MethodConverter() {
      super(SmoothMethod.values());
    }
  }

  /** The runs on one map. */
  record Report(List<SmoothRun.Report> runs) {}

  @Override
  public Integer call() {
    Arguments arguments = new Arguments(spec);
    if (!(radius >= SMALLEST_RADIUS && radius <= LARGEST_RADIUS)) {
      throw arguments.invalid("--radius %s: it must be from 0.001 to 1000".formatted(radius));
    }
    return map == null ? planInScenes(arguments) : planOnMap(arguments, map);
  }

  private int planOnMap(Arguments arguments, Path file) {
    if (from == null || to == null || limitMs == null) {
      throw arguments.invalid("With --map, the options --from, --to and --limit-ms are needed");
    }
    if (scenes != null) {
      throw arguments.invalid("--scenes is for random scenes, without --map");
    }
    int repeats = repeat == null ? 1 : repeat;
    int millis = limitMs;
    arguments.requireBetween("--limit-ms", millis, 1, MOST_MS);
    arguments.requireBetween("--repeat", repeats, 1, MOST_REPEATS);
    OccupancyGrid grid = arguments.readGrid(file);
    SmoothRun run = new SmoothRun(grid, radius, method, from.position(), to.position());
    run.warmUp(millis);
    List<SmoothRun.Report> runs =
        LongStream.range(0, repeats).mapToObj(i -> run.plan(seed.value() + i, millis)).toList();
    new BenchOutput(spec).printReport(new Report(runs));
    return runs.stream().allMatch(SmoothRun.Report::found) ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private int planInScenes(Arguments arguments) {
    if (from != null || to != null || limitMs != null || repeat != null) {
      throw arguments.invalid("--from, --to, --limit-ms and --repeat need --map");
    }
    int count = scenes == null ? 100 : scenes;
    arguments.requireBetween("--scenes", count, 1, MOST_SCENES);
    if (radius > LARGEST_IN_SCENE) {
      throw arguments.invalid(
          "--radius %s: without --map it must be at most 0.2".formatted(radius));
    }
    SmoothScenes run = new SmoothScenes(radius, method, seed.value(), count);
    SmoothScenes.Report report = run.measure(SCENE_LIMITS);
    new BenchOutput(spec).printReport(report);
    boolean hasFailed = report.limits().stream().anyMatch(l -> l.failures() + l.touching() > 0);
    return hasFailed ? ExitCode.SOFTWARE : ExitCode.OK;
  }
}
