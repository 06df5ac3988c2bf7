package org.toqa.app.bench;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.TrafficRun.Report;
import org.toqa.app.bench.TrafficRun.StepListener;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.RequiredMapOption;
import org.toqa.app.command.SeedOption;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.check.TrafficChecker.Violation;
import org.toqa.traffic.lifelong.LifelongPlanner;
import org.toqa.traffic.lifelong.ReservationPlanner;
import org.toqa.traffic.lifelong.RollingHorizonPlanner;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench traffic}: robots that get a new goal whenever they reach one. */
@Command(
    name = "traffic",
    description = "Run many robots that get a new goal whenever they reach one.",
    footer = {
      "",
      "Prints JSON: goals (number reached), collisions, stuck (robots that have not",
      "moved for the last 50 steps and are not at their goal), p50Ms and p99Ms",
      "(planning time of a step), goalsPerStep, steps. Exits 1 if robots collided."
    })
final class TrafficBench implements Callable<Integer> {
  private static final int MAX_ROBOTS = 20_000;
  private static final int MAX_STEPS = 1_000_000;
  private static final int MAX_LIMIT_MS = 60_000;
  private static final int SMALL_FLEET_ROBOTS = 500;
  private static final int SMALL_FLEET_LIMIT_MS = 8;
  private static final int LARGE_FLEET_LIMIT_MS = 60;

  /** The same is driven for so long before anything is measured, milliseconds. */
  private static final int WARM_UP_MS = 3_000;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private RequiredMapOption map = new RequiredMapOption();

  @Option(
      names = "--robots",
      paramLabel = "N",
      description = "Number of robots; with --tasks, the first N of the file (default: all).")
  private @Nullable Integer robots;

  @Option(
      names = "--steps",
      required = true,
      paramLabel = "T",
      description = "Number of steps, 1 to " + MAX_STEPS + ".")
  private int steps;

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--model",
      defaultValue = "classic",
      paramLabel = "classic|turns",
      description =
          "Moves of a robot in a step. classic: to one of four neighbouring cells, or wait; turns:"
              + " forward, turn by 90 degrees, or wait (default: ${DEFAULT-VALUE}).")
  private String model = "classic";

  @Option(
      names = "--planner",
      defaultValue = "rolling",
      paramLabel = "rolling|reservation",
      description =
          "rolling: the fleet's planner; reservation: first come, first served (default:"
              + " ${DEFAULT-VALUE}).")
  private String planner = "rolling";

  @Option(
      names = "--no-rings",
      description =
          "The rolling planner lets robots never go round in a full ring all at once: on a real"
              + " floor a cell must be left before it is entered.")
  private boolean noRings;

  @Option(
      names = "--limit-ms",
      paramLabel = "MS",
      description =
          "Time limit for planning a step, in milliseconds (default: 8, or 60 for more than 500"
              + " robots).")
  private @Nullable Integer limitMs;

  @Option(
      names = "--tasks",
      paramLabel = "FILE",
      description =
          "Read starts and goals from FILE instead of choosing them at random: one line per"
              + " robot, column,row each.")
  private @Nullable Path tasks;

  @Option(
      names = "--trace",
      paramLabel = "FILE",
      description =
          "Write all steps to FILE: one line per step, robots as column,row or column,row,H.")
  private @Nullable Path trace;

  @Override
  public Integer call() throws IOException {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--steps", steps, 1, MAX_STEPS);
    if (limitMs != null) {
      arguments.requireBetween("--limit-ms", limitMs, 1, MAX_LIMIT_MS);
    }
    if (trace != null) {
      arguments.requireWritable(trace);
    }
    OccupancyGrid grid = arguments.readGrid(map.file());
    StanceFormat lines = new StanceFormat(motionModel(arguments));
    Deadline warmUp = Deadline.in(Duration.ofMillis(WARM_UP_MS), System::nanoTime);
    trafficRun(grid, new TraceListener(lines, Writer.nullWriter()), arguments).run(steps, warmUp);
    Report report;
    try (Writer writer =
        trace == null ? Writer.nullWriter() : Files.newBufferedWriter(trace, UTF_8)) {
      report =
          trafficRun(grid, new TraceListener(lines, writer), arguments).run(steps, Deadline.none());
    }
    new BenchOutput(spec).printReport(report);
    return report.collisions() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private TrafficRun trafficRun(OccupancyGrid grid, StepListener witness, Arguments arguments) {
    MotionModel motion = motionModel(arguments);
    RoadGraph roads = new RoadGraph(grid);
    Workload work =
        tasks == null
            ? randomWorkload(roads, arguments)
            : Workload.listed(tasks, robots, roads, arguments);
    Duration limit = limit(work.starts().size());
    return new TrafficRun(
        roads,
        motion,
        trafficPlanner(motion, arguments),
        work.starts(),
        work.goals(),
        () -> Deadline.in(limit, System::nanoTime),
        witness);
  }

  private Duration limit(int robots) {
    int usual = robots > SMALL_FLEET_ROBOTS ? LARGE_FLEET_LIMIT_MS : SMALL_FLEET_LIMIT_MS;
    return Duration.ofMillis(limitMs == null ? usual : limitMs);
  }

  private final class TraceListener implements StepListener {
    private final StanceFormat lines;
    private final Writer writer;

    TraceListener(StanceFormat lines, Writer writer) {
      this.lines = lines;
      this.writer = writer;
    }

    @Override
    public void stepTaken(List<GridPose> stances) throws IOException {
      if (trace != null) {
        writer.write(lines.line(stances));
        writer.write('\n');
      }
    }

    @Override
    public void violationFound(int step, Violation violation) {
      new CommandOutput(spec).printError("step " + step + ": " + violation);
    }
  }

  private MotionModel motionModel(Arguments arguments) {
    return switch (model) {
      case "classic" -> MotionModel.CLASSIC;
      case "turns" -> MotionModel.TURNS;
      default -> throw arguments.invalid("--model " + model + ": it is classic or turns");
    };
  }

  private LifelongPlanner trafficPlanner(MotionModel motion, Arguments arguments) {
    return switch (planner) {
      case "rolling" -> new RollingHorizonPlanner(motion, !noRings, seed.value());
      case "reservation" -> {
        if (noRings) {
          throw arguments.invalid("--no-rings is for --planner rolling");
        }
        yield new ReservationPlanner(motion);
      }
      default -> throw arguments.invalid("--planner " + planner + ": it is rolling or reservation");
    };
  }

  private Workload randomWorkload(RoadGraph roads, Arguments arguments) {
    if (robots == null) {
      throw arguments.invalid("--robots is missing");
    }
    arguments.requireBetween("--robots", robots, 1, Math.min(MAX_ROBOTS, Workload.most(roads)));
    return Workload.random(roads, robots, seed.value());
  }
}
