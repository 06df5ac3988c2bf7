package org.toqa.app.bench;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.FloorRun.Report;
import org.toqa.app.bench.FloorRun.World;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.RequiredMapOption;
import org.toqa.app.command.SeedOption;
import org.toqa.app.server.Logging;
import org.toqa.grid.FloorMap;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench floor}: the floor's own agents over simulated robots, in simulated time. */
@Command(
    name = "floor",
    description = "Run the traffic of a real floor with exact bodies, in simulated time.",
    footer = {
      "",
      "Robots get a new goal whenever they reach one; the same --seed gives the starts",
      "and goals of bench traffic. No sockets and no second thread: the same seed",
      "drives the same way wherever no planning ends by its limit, or with",
      "--look-nanos.",
      "",
      "Prints JSON: goals (number reached), goalsPerSecond, goalsPerStep (a step is",
      "what a robot takes to the next cell, stepSeconds), planP50Ms and planP99Ms (one",
      "plan of several robots, real time), tickP99Ms (one tick of the floor, real",
      "time), longestWaitSeconds, longestWaitRobot, longestWaitReason (what the floor",
      "said why), longestUnnamedWaitSeconds (while it did not say why), contacts and",
      "wallContacts (how often bodies came to touch), nearestMetres and",
      "nearestWallMetres (between edges where they really were), metres (all robots",
      "together), speed (simulated seconds per second), processorSeconds,",
      "agentSeconds, planSeconds and robotSeconds (where the time went), leavesOut",
      "(what is not measured).",
      "",
      "Exits 1 if a body touched another one or a wall, or an agent failed."
    })
final class FloorBench implements Callable<Integer> {
  private static final int MAX_ROBOTS = 20_000;
  private static final int MAX_SECONDS = 1_000_000;
  private static final int MAX_DELAY_MS = 1_000;
  private static final int MAX_PLANNING_MS = 10_000;
  private static final int MAX_LOOK_NANOS = 1_000_000;
  private static final int MAX_WARM_UP = 3_600;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private RequiredMapOption map = new RequiredMapOption();

  @Option(
      names = "--robots",
      paramLabel = "N",
      description =
          "Number of robots, each on a cell of its own; with --tasks, the first N of the file"
              + " (default: all).")
  private @Nullable Integer robots;

  @Option(
      names = "--tasks",
      paramLabel = "FILE",
      description =
          "Read starts and goals from FILE instead of choosing them at random: one line per"
              + " robot, column,row each. A robot that has reached all stays.")
  private @Nullable Path tasks;

  @Option(
      names = "--seconds",
      required = true,
      paramLabel = "S",
      description = "Simulated seconds, 1 to " + MAX_SECONDS + ".")
  private int seconds;

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--pose-error",
      defaultValue = "0.02",
      paramLabel = "M",
      description =
          "Metres by which a body is beside where its robot reports itself, at most, 0 to 1"
              + " (default: ${DEFAULT-VALUE}).")
  private double poseError;

  @Option(
      names = "--store-ms",
      defaultValue = "10",
      paramLabel = "MS",
      description =
          "Simulated milliseconds until a change is stored, 0 to 1000 (default:"
              + " ${DEFAULT-VALUE}).")
  private int storeMs;

  @Option(
      names = "--link-ms",
      defaultValue = "20",
      paramLabel = "MS",
      description =
          "Simulated milliseconds that a message takes between robot and server, 0 to 1000"
              + " (default: ${DEFAULT-VALUE}).")
  private int linkMs;

  @Option(
      names = "--planning-ms",
      defaultValue = "20",
      paramLabel = "MS",
      description =
          "Simulated milliseconds from when the floor is pictured until the plan for that is"
              + " ready, 0 to 10000; robots drive on meanwhile (default: ${DEFAULT-VALUE}).")
  private int planningMs;

  @Option(
      names = "--look-nanos",
      defaultValue = "0",
      paramLabel = "N",
      description =
          "Planning is taken to last N nanoseconds from one look at its clock to the next, so that"
              + " its limits are the same on every machine; 0: real time, as in a server (default:"
              + " ${DEFAULT-VALUE}).")
  private int lookNanos;

  @Option(
      names = "--warm-up",
      defaultValue = "3",
      paramLabel = "S",
      description =
          "Real seconds for which the same is run before it is measured, 0 to 3600 (default:"
              + " ${DEFAULT-VALUE}).")
  private int warmUp;

  @Override
  public Integer call() {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--seconds", seconds, 1, MAX_SECONDS);
    arguments.requireDecimalBetween("--pose-error", poseError, 0, 1);
    arguments.requireBetween("--store-ms", storeMs, 0, MAX_DELAY_MS);
    arguments.requireBetween("--link-ms", linkMs, 0, MAX_DELAY_MS);
    arguments.requireBetween("--planning-ms", planningMs, 0, MAX_PLANNING_MS);
    arguments.requireBetween("--look-nanos", lookNanos, 0, MAX_LOOK_NANOS);
    arguments.requireBetween("--warm-up", warmUp, 0, MAX_WARM_UP);
    FloorMap floor = arguments.readFloor(map.file());
    Logging.changeLevel("WARN"); // a line for each robot tells nothing here
    RoadGraph roads = new RoadGraph(floor.grid());
    if (warmUp > 0) {
      try (FloorRun run = new FloorRun(world(floor, roads, arguments))) {
        Deadline end = Deadline.in(Duration.ofSeconds(warmUp), System::nanoTime);
        run.run(Duration.ofSeconds(seconds), end);
      }
    }
    try (FloorRun run = new FloorRun(world(floor, roads, arguments))) {
      run.run(Duration.ofSeconds(seconds), Deadline.none());
      Report report = run.report();
      new BenchOutput(spec).printReport(report);
      List<String> failures = failures(report, run.failures());
      failures.forEach(new CommandOutput(spec)::printError);
      return failures.isEmpty() ? ExitCode.OK : ExitCode.SOFTWARE;
    }
  }

  private World world(FloorMap floor, RoadGraph roads, Arguments arguments) {
    return new World(
        floor,
        tasks == null
            ? randomWorkload(roads, arguments)
            : Workload.listed(tasks, robots, roads, arguments),
        poseError,
        Duration.ofMillis(storeMs),
        Duration.ofMillis(linkMs),
        Duration.ofMillis(planningMs),
        Duration.ofNanos(lookNanos),
        seed.value());
  }

  private Workload randomWorkload(RoadGraph roads, Arguments arguments) {
    if (robots == null) {
      throw arguments.invalid("--robots is missing");
    }
    arguments.requireBetween("--robots", robots, 1, Math.min(MAX_ROBOTS, Workload.most(roads)));
    return Workload.random(roads, robots, seed.value());
  }

  /** What is not as it must be, in sentences. */
  private static List<String> failures(Report report, List<String> ofAgents) {
    List<String> failures = new ArrayList<>(ofAgents);
    if (report.contacts() > 0) {
      failures.add("in truth, two robots touched " + report.contacts() + " times");
    }
    if (report.wallContacts() > 0) {
      failures.add("in truth, a robot touched a wall " + report.wallContacts() + " times");
    }
    return failures;
  }
}
