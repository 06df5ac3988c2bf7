package org.toqa.app.bench;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.RequiredMapOption;
import org.toqa.app.command.SeedOption;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Scenario;
import org.toqa.planning.Heading;
import org.toqa.statistics.Percentiles;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.check.TrafficChecker;
import org.toqa.traffic.check.TrafficChecker.Violation;
import org.toqa.traffic.mapf.MapfInstance;
import org.toqa.traffic.mapf.MapfPlan;
import org.toqa.traffic.mapf.MapfResult;
import org.toqa.traffic.mapf.MapfResult.Solved;
import org.toqa.traffic.mapf.MapfResult.Unsolved;
import org.toqa.traffic.mapf.OneShotPlanner;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench mapf}: paths for all robots of a scenario, planned in one go. */
@Command(
    name = "mapf",
    description = "Plan paths for all robots of a scenario at once.",
    footer = {
      "",
      "In each step a robot moves to one of four neighbouring cells or waits.",
      "",
      "Prints JSON: solved, firstMs (until the first plan, median), sumOfCosts (steps",
      "until each robot stays at its goal, all robots together), lowerBound (the same",
      "if each robot were alone), elapsedMs (until the planner truly ended, which has",
      "limitMs for it), leavesOut (what is not measured). Exits 1 if there is no plan."
    })
final class MapfBench implements Callable<Integer> {
  private static final int MAX_ROBOTS = 20_000;
  private static final int MAX_LIMIT_MS = 3_600_000;
  private static final int MAX_REPEATS = 1000;

  /** First plans are made for so long before any is measured. */
  private static final int WARM_UP_MS = 3_000;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private RequiredMapOption map = new RequiredMapOption();

  @Option(
      names = "--scen",
      required = true,
      paramLabel = "FILE",
      description =
          "MovingAI scenario file with starts and goals; those of further robots are random.")
  private Path scen = Path.of("");

  @Option(names = "--robots", required = true, paramLabel = "N", description = "Number of robots.")
  private int robots;

  @Option(
      names = "--limit-ms",
      required = true,
      paramLabel = "T",
      description = "Time limit for improving the plan, in milliseconds.")
  private int limitMs;

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--repeat",
      defaultValue = "10",
      paramLabel = "R",
      description =
          "Number of times to make the first plan, for the median of its time (default:"
              + " ${DEFAULT-VALUE}; fewer if that takes longer than T).")
  private int repeat;

  @Option(
      names = "--plan",
      paramLabel = "FILE",
      description = "Write the plan to FILE: one line per step, robots as column,row.")
  private @Nullable Path plan;

  /**
   * @param firstMs until the first plan, milliseconds, the median of the repeats
   * @param sumOfCosts steps until each robot stays at its goal, summed
   * @param lowerBound the same, were each robot alone
   * @param elapsedMs until the planner truly ended, milliseconds
   * @param limitMs until it should have ended, milliseconds
   */
  record Report(
      boolean solved,
      @Nullable Double firstMs,
      @Nullable Long sumOfCosts,
      @Nullable Long lowerBound,
      double elapsedMs,
      int limitMs) {}

  @Override
  public Integer call() throws IOException {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--robots", robots, 1, MAX_ROBOTS);
    arguments.requireBetween("--limit-ms", limitMs, 1, MAX_LIMIT_MS);
    arguments.requireBetween("--repeat", repeat, 1, MAX_REPEATS);
    if (plan != null) {
      arguments.requireWritable(plan);
    }
    OccupancyGrid grid = arguments.readGrid(map.file());
    Report report =
        measure(
            grid, instance(new RoadGraph(grid), arguments.readScenarios(scen, grid), arguments));
    new BenchOutput(spec).printReport(report);
    return report.solved() ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  /** The scenario's first robots; more than it has, by chance in the largest connected part. */
  private MapfInstance instance(RoadGraph roads, List<Scenario> scenarios, Arguments arguments) {
    List<Cell> starts = scenarios.stream().limit(robots).map(Scenario::start).toList();
    List<Cell> goals = scenarios.stream().limit(robots).map(Scenario::goal).toList();
    int missing = robots - starts.size();
    if (missing == 0) {
      return new MapfInstance(roads, starts, goals);
    }
    printError(
        "the scenario has %d robots; %d more stand and go anywhere, by seed %d"
            .formatted(starts.size(), missing, seed.value()));
    Random random = new Random(seed.value());
    return new MapfInstance(
        roads,
        filledUpCells(starts, roads, random, arguments),
        filledUpCells(goals, roads, random, arguments));
  }

  private List<Cell> filledUpCells(
      List<Cell> cells, RoadGraph roads, Random random, Arguments arguments) {
    Set<Cell> taken = Set.copyOf(cells);
    List<Cell> free =
        new ArrayList<>(
            IntStream.range(0, roads.vertexCount())
                .filter(roads::isInLargestPart)
                .mapToObj(roads::cell)
                .filter(cell -> !taken.contains(cell))
                .toList());
    arguments.requireBetween("--robots", robots, 1, cells.size() + free.size());
    Collections.shuffle(free, random);
    return Stream.concat(cells.stream(), free.stream()).limit(robots).toList();
  }

  private Report measure(OccupancyGrid grid, MapfInstance instance) throws IOException {
    firstPlans(instance, Integer.MAX_VALUE, Math.min(limitMs, WARM_UP_MS));
    List<Double> firsts = firstPlans(instance, repeat - 1, limitMs);
    Deadline deadline = Deadline.in(Duration.ofMillis(limitMs), System::nanoTime);
    long begin = System.nanoTime();
    MapfResult result = solve(instance, deadline, firsts, () -> {});
    double elapsedMs = millisSince(begin);
    return switch (result) {
      case Unsolved unsolved -> {
        printError("not solved: " + reason(unsolved));
        yield new Report(false, null, null, null, elapsedMs, limitMs);
      }
      case Solved(MapfPlan found, long lowerBound) -> {
        List<Violation> violations = check(grid, instance, found);
        violations.forEach(violation -> printError(violation.toString()));
        write(found);
        yield new Report(
            violations.isEmpty(),
            median(firsts),
            found.sumOfCosts(),
            lowerBound,
            elapsedMs,
            limitMs);
      }
    };
  }

  /** The milliseconds that first plans took: so many, or as many as there was time for. */
  private List<Double> firstPlans(MapfInstance instance, int count, int millis) {
    List<Double> firsts = new ArrayList<>();
    long begin = System.nanoTime();
    boolean isSolved = true;
    while (isSolved && firsts.size() < count && millisSince(begin) < millis) {
      AtomicBoolean found = new AtomicBoolean();
      Deadline untilFirst =
          new Deadline(() -> found.get() || millisSince(begin) > 2.0 * limitMs ? 1 : 0, 1);
      isSolved = solve(instance, untilFirst, firsts, () -> found.set(true)) instanceof Solved;
    }
    return firsts;
  }

  /**
   * @param firsts gets the milliseconds to the first plan
   */
  private MapfResult solve(
      MapfInstance instance, Deadline deadline, List<Double> firsts, Runnable onFirst) {
    long begin = System.nanoTime();
    return new OneShotPlanner(seed.value())
        .solve(
            instance,
            deadline,
            found -> {
              firsts.add(millisSince(begin));
              onFirst.run();
            });
  }

  private static double millisSince(long nanos) {
    return (System.nanoTime() - nanos) / 1e6;
  }

  private static double median(List<Double> times) {
    return new Percentiles(times.stream().mapToDouble(Double::doubleValue).toArray())
        .percentile(0.5);
  }

  private void printError(String sentence) {
    new CommandOutput(spec).printError(sentence);
  }

  private static String reason(Unsolved unsolved) {
    MapfResult.Culprit culprit = unsolved.robot();
    return culprit == null
        ? unsolved.reason().name()
        : "%s (line %d, cell %s)".formatted(unsolved.reason(), culprit.index() + 1, culprit.cell());
  }

  /** What is wrong with a plan, by the checker, which knows no planner. */
  private static List<Violation> check(OccupancyGrid grid, MapfInstance instance, MapfPlan plan) {
    TrafficChecker checker = new TrafficChecker(grid, MotionModel.CLASSIC);
    List<GridPose> before = stances(plan, 0);
    List<Violation> violations = new ArrayList<>(checker.checkPlaces(before));
    violations.addAll(misplacedRobots(before, instance.starts()));
    for (int step = 1; step <= plan.makespan(); step++) {
      List<GridPose> after = stances(plan, step);
      violations.addAll(checker.check(before, after));
      before = after;
    }
    violations.addAll(misplacedRobots(before, instance.goals()));
    return violations;
  }

  private static List<Violation> misplacedRobots(List<GridPose> stances, List<Cell> expected) {
    return IntStream.range(0, stances.size())
        .filter(robot -> !stances.get(robot).cell().equals(expected.get(robot)))
        .mapToObj(
            robot ->
                new Violation(
                    TrafficChecker.Rule.A_STEP_OF_THE_MODEL, robot, stances.get(robot).cell()))
        .toList();
  }

  private static List<GridPose> stances(MapfPlan plan, int step) {
    return IntStream.range(0, plan.robotCount())
        .mapToObj(robot -> new GridPose(plan.at(robot, step), Heading.EAST))
        .toList();
  }

  private void write(MapfPlan found) throws IOException {
    if (plan == null) {
      return;
    }
    StanceFormat lines = new StanceFormat(MotionModel.CLASSIC);
    try (BufferedWriter writer = Files.newBufferedWriter(plan, UTF_8)) {
      for (int step = 0; step <= found.makespan(); step++) {
        writer.write(lines.line(stances(found, step)));
        writer.write('\n');
      }
    }
  }
}
