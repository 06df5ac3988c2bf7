package org.toqa.app.bench;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Assignment;
import org.toqa.app.bench.meter.ProcessorTime;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.command.SeedOption;
import org.toqa.app.server.WebappFolder;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.statistics.Percentiles;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench allocation}: the same work under each allocator. */
@Command(
    name = "allocation",
    description = "Compare the allocators on the same tasks.",
    footer = {
      "",
      "Prints JSON, by policy: delivered, meanSeconds and worstSeconds (from when a",
      "task arrives until it is delivered), joules and metres (all robots together),",
      "roundP99Ms (processor time of an allocation round). Of contract-net also, in",
      "negotiations: bids, declined, silent, awards, awardsReturned, trades,",
      "tradesVoid, tasksTraded, largestTrade (robots), joulesSaved, and how long one",
      "took (meanMs, worstMs, simulated). Exits 1 if a task was not delivered.",
      "",
      "Paths are planned on the map. Robots drive at 0.25 m/s and do not block each",
      "other. Every third robot carries 10 kg, the others 5 kg; a fifth of the loads",
      "needs a 10 kg robot."
    })
final class AllocationBench implements Callable<Integer> {
  private static final int SOLVER_RUNS = 15;

  private final Supplier<Path> shippedMap;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--robots",
      defaultValue = "8",
      paramLabel = "N",
      description = "Number of robots, 1 to 1000 (default: ${DEFAULT-VALUE}).")
  private int robots;

  @Mixin private TaskCountOption tasks = new TaskCountOption(500);

  @Option(
      names = "--pressure",
      defaultValue = "80",
      paramLabel = "PERCENT",
      description =
          "Load of the fleet in percent of its capacity, 1 to 200 (default: ${DEFAULT-VALUE}).")
  private int pressure;

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--slow",
      defaultValue = "0",
      paramLabel = "PERCENT",
      description =
          "Percentage of robots that drive at half speed, 0 to 100 (default: ${DEFAULT-VALUE}).")
  private int slow;

  @Mixin private BidderFaults bidders = new BidderFaults();

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Option(
      names = "--policy",
      defaultValue = "all",
      paramLabel = "all|nearest|zones|contract-net|optimal",
      converter = PolicyChoice.Converter.class,
      description = "Allocator to measure (default: all).")
  private PolicyChoice policy = PolicyChoice.ALL;

  @Option(
      names = "--exchange",
      description = "Allow tasks to change robots until their loads are picked up.")
  private boolean exchange;

  @Option(
      names = "--solver-size",
      paramLabel = "K",
      description = "Also time the assignment of K tasks to K robots, 1 to 5000.")
  private @Nullable Integer solverSize;

  /**
   * @param solverMs median processor time of one assignment, milliseconds
   */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  record Report(
      int robots,
      int tasks,
      long seed,
      Map<String, AllocationRun.Report> policies,
      @Nullable Double solverMs) {}

  AllocationBench() {
    this(WebappFolder::shippedMap);
  }

  /**
   * @param shippedMap the map where none is named
   */
  AllocationBench(Supplier<Path> shippedMap) {
    this.shippedMap = shippedMap;
  }

  @Override
  public Integer call() {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--robots", robots, 1, 1000);
    tasks.check(arguments);
    arguments.requireBetween("--pressure", pressure, 1, 200);
    arguments.requireBetween("--slow", slow, 0, 100);
    arguments.requireBetween("--silent", bidders.silent, 0, robots);
    arguments.requireBetween("--slow-bidders", bidders.slow, 0, robots);
    arguments.requireBetween("--bidder-delay", bidders.delay, 0, 10_000);
    if (solverSize != null) {
      arguments.requireBetween("--solver-size", solverSize, 1, 5000);
    }
    AllocationWorkload workload = workload(arguments);
    Map<String, AllocationRun.Report> reports = new LinkedHashMap<>();
    policy
        .methods()
        .forEach(
            (word, method) ->
                reports.put(word, new AllocationRun(workload, method, exchange, bidders).run()));
    Report report =
        new Report(
            robots,
            tasks.value(),
            seed.value(),
            reports,
            solverSize == null ? null : solverMillis(solverSize));
    new BenchOutput(spec).printReport(report);
    boolean allDelivered = reports.values().stream().allMatch(r -> r.delivered() == tasks.value());
    return allDelivered ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private AllocationWorkload workload(Arguments arguments) {
    FloorMap floor = arguments.readFloor(mapFile());
    try {
      return AllocationWorkload.of(
          floor,
          Inflation.inflate(floor.grid(), AllocationWorkload.DIAMETER / 2),
          robots,
          tasks.value(),
          pressure / 100.0,
          slow / 100.0,
          seed.value());
    } catch (IllegalArgumentException e) {
      throw arguments.invalid("--robots " + robots + ": " + e.getMessage());
    }
  }

  private Path mapFile() {
    String named = map.file();
    return named == null ? shippedMap.get() : Path.of(named);
  }

  /** Robots and loads anywhere in a square; the first runs warm up. */
  private double solverMillis(int size) {
    Random random = new Random(seed.value());
    double[] millis =
        IntStream.range(0, 2 * SOLVER_RUNS)
            .mapToDouble(
                run -> {
                  double[] costs = distances(size, random);
                  double begin = ProcessorTime.millis();
                  Assignment.leastCost(costs, size);
                  return ProcessorTime.millis() - begin;
                })
            .skip(SOLVER_RUNS)
            .toArray();
    return new Percentiles(millis).percentile(0.5);
  }

  private static double[] distances(int size, Random random) {
    Vec2[] loads = points(size, random);
    Vec2[] places = points(size, random);
    double[] distances = new double[size * size];
    for (int i = 0; i < distances.length; i++) {
      distances[i] = loads[i / size].distanceTo(places[i % size]);
    }
    return distances;
  }

  private static Vec2[] points(int size, Random random) {
    return IntStream.range(0, size)
        .mapToObj(i -> new Vec2(random.nextDouble(), random.nextDouble()))
        .toArray(Vec2[]::new);
  }
}
