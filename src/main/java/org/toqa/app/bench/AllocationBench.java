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
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Assignment;
import org.toqa.app.command.Arguments;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.statistics.Percentiles;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.databind.json.JsonMapper;

/** {@code toqa bench allocation}: the same work under each allocator. */
@Command(
    name = "allocation",
    description = "Lets each allocator deal out the same work, by seed.",
    footer = {
      "",
      "JSON, by policy: delivered, meanSeconds and worstSeconds (from a task's",
      "coming to its delivery), joules and metres (of all robots), roundP99Ms (processor time).",
      "",
      "Ways are the planner's, on the map; robots drive at 0.25 m/s and do not",
      "hinder each other. Every third robot carries 10 kg, the others 5 kg; a",
      "fifth of the loads needs a strong one."
    })
public final class AllocationBench implements Callable<Integer> {
  private static final int SOLVER_RUNS = 15;

  private final Supplier<Path> shippedMap;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--robots",
      defaultValue = "8",
      paramLabel = "N",
      description = "How many, 1 to 1000 (default: ${DEFAULT-VALUE}).")
  private int robots;

  @Option(
      names = "--tasks",
      defaultValue = "500",
      paramLabel = "M",
      description = "How many, 1 to 100000 (default: ${DEFAULT-VALUE}).")
  private int tasks;

  @Option(
      names = "--seed",
      defaultValue = "1",
      paramLabel = "S",
      description = "Of the work (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--pressure",
      defaultValue = "80",
      paramLabel = "PERCENT",
      description =
          "The work as a part of what the robots could do, 1 to 200 (default: ${DEFAULT-VALUE}).")
  private int pressure;

  @Option(
      names = "--slow",
      defaultValue = "0",
      paramLabel = "PERCENT",
      description =
          "Of the robots, so many drive at half the speed, 0 to 100 (default: ${DEFAULT-VALUE}).")
  private int slow;

  @Option(
      names = "--map",
      paramLabel = "FILE",
      description = "A MovingAI map, or the yaml file of a map_server pair (default: shipped map).")
  private @Nullable Path map;

  @Option(
      names = "--policy",
      defaultValue = "all",
      paramLabel = "all|nearest|zones|contract-net|optimal",
      converter = PolicyChoice.Converter.class,
      description = "Which allocator (default: all).")
  private PolicyChoice policy = PolicyChoice.ALL;

  @Option(
      names = "--exchange",
      description = "Lets tasks whose loads are not picked up go to other robots.")
  private boolean exchange;

  @Option(
      names = "--solver-size",
      paramLabel = "K",
      description = "Also times the assignment of K tasks to K robots, 1 to 5000.")
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

  /**
   * @param shippedMap the map where none is named
   */
  public AllocationBench(Supplier<Path> shippedMap) {
    this.shippedMap = shippedMap;
  }

  @Override
  public Integer call() {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--robots", robots, 1, 1000);
    arguments.requireBetween("--tasks", tasks, 1, 100_000);
    arguments.requireBetween("--pressure", pressure, 1, 200);
    arguments.requireBetween("--slow", slow, 0, 100);
    if (solverSize != null) {
      arguments.requireBetween("--solver-size", solverSize, 1, 5000);
    }
    AllocationWorkload shift = workload(arguments);
    Map<String, AllocationRun.Report> reports = new LinkedHashMap<>();
    for (Map.Entry<String, Allocator> entry : policy.allocators().entrySet()) {
      reports.put(entry.getKey(), new AllocationRun(shift, entry.getValue(), exchange).run());
    }
    Report report =
        new Report(
            robots, tasks, seed, reports, solverSize == null ? null : solverMillis(solverSize));
    spec.commandLine().getOut().println(JsonMapper.shared().writeValueAsString(report));
    boolean allDelivered = reports.values().stream().allMatch(r -> r.delivered() == tasks);
    return allDelivered ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private AllocationWorkload workload(Arguments arguments) {
    FloorMap floor = arguments.readFloor(map == null ? shippedMap.get() : map);
    try {
      return AllocationWorkload.of(
          floor,
          Inflation.inflate(floor.grid(), AllocationWorkload.DIAMETER / 2),
          robots,
          tasks,
          pressure / 100.0,
          slow / 100.0,
          seed);
    } catch (IllegalArgumentException e) {
      throw arguments.invalid("--robots " + robots + ": " + e.getMessage());
    }
  }

  /** Robots and loads anywhere in a square; the first runs warm up. */
  private double solverMillis(int size) {
    Random random = new Random(seed);
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
