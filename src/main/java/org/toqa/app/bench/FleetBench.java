package org.toqa.app.bench;

import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.FleetMeter.Report;
import org.toqa.app.bench.meter.MeasuringTime;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.command.SeedOption;
import org.toqa.app.command.SpeedOption;
import org.toqa.app.command.StopSignal;
import org.toqa.app.command.TemporaryFolder;
import org.toqa.app.config.Setting;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.FleetServer.BodyObservation;
import org.toqa.app.server.ServerOperation;
import org.toqa.app.server.WebappFolder;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorWriter;
import org.toqa.grid.Place;
import org.toqa.sim.ClearanceJudge;
import org.toqa.sim.ClearanceJudge.Clearance;
import org.toqa.traffic.RoadGraph;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench fleet}: what a whole fleet costs that always has something to carry. */
@Command(
    name = "fleet",
    description = "Measure a complete server with simulated robots.",
    footer = {
      "",
      "Random tasks keep all robots busy.",
      "",
      "Prints JSON: pace (simulated seconds per second; below the --speed if the",
      "machine cannot keep up), cores (processor seconds per second of the whole",
      "process), metresDriven and tasksDone (all robots together), nearestMetres (the",
      "smallest distance between the edges of two robots of a floor as they report",
      "themselves),",
      "trueNearestMetres and trueWallMetres (the smallest distance between two bodies,",
      "and between one and a wall, where they really were, looked for trueSamples",
      "times), heapBeforeMb and heapAfterMb (memory in use at the start and at the",
      "end), leavesOut (what is not measured).",
      "",
      "Exits 1 if a body touched another one or a wall, or below the least pace."
    })
final class FleetBench implements Callable<Integer> {

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--robots",
      required = true,
      paramLabel = "N",
      description = "Number of robots, 2 to 500; with --floors on each floor.")
  private int robots;

  @Option(
      names = "--floors",
      defaultValue = "1",
      paramLabel = "N",
      description = "Number of floors that look alike, 1 to 100 (default: ${DEFAULT-VALUE}).")
  private int floors;

  @Mixin private MeasuringTime time = new MeasuringTime();

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private SpeedOption speed = new SpeedOption();

  @Option(
      names = "--least-pace",
      defaultValue = "0.5",
      paramLabel = "N",
      description =
          "Least simulated seconds per second that pass, 0 to 100 (default: ${DEFAULT-VALUE}).")
  private double leastPace;

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Option(
      names = "--write-tasks",
      paramLabel = "FILE",
      description =
          "Write to FILE where robots are when measuring begins and where they are sent"
              + " meanwhile, for bench floor --tasks.")
  private @Nullable Path tasks;

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--robots", robots, 2, 500);
    arguments.requireBetween("--floors", floors, 1, 100);
    arguments.requireDecimalBetween("--least-pace", leastPace, 0, 100);
    time.check(arguments);
    if (tasks != null) {
      arguments.requireWritable(tasks);
    }
    ServerOperation measurement = this::measure;
    if (floors == 1) {
      return measurement.runIsolated(settings());
    }
    try (TemporaryFolder maps = TemporaryFolder.create("toqa-floors")) {
      Map<Setting, @Nullable String> settings = settings();
      settings.put(Setting.MAP, copies(arguments, settings.get(Setting.MAP), maps.path()));
      settings.put(
          Setting.SIMULATE, String.join(",", Collections.nCopies(floors, String.valueOf(robots))));
      return measurement.runIsolated(settings);
    }
  }

  /** As many maps as there are floors, as the configuration names them. */
  private String copies(Arguments arguments, @Nullable String map, Path folder) throws IOException {
    Path file = map == null ? WebappFolder.shippedMap() : Path.of(map);
    FloorDrawing drawing = arguments.readFloor(file).drawing();
    List<String> files = new ArrayList<>();
    for (int i = 1; i <= floors; i++) {
      FloorWriter.mapServerFiles("floor" + i, named(drawing, i)).writeTo(folder);
      files.add(folder.resolve("floor" + i + ".yaml").toString());
    }
    return String.join(File.pathSeparator, files);
  }

  /** With stations of its own, since their names are unique in a site. */
  private static FloorDrawing named(FloorDrawing drawing, int floor) {
    return drawing.withStations(
        drawing.stations().stream()
            .map(
                station ->
                    new Place(
                        station.name() + " " + floor,
                        station.position(),
                        station.heading(),
                        station.approach()))
            .toList());
  }

  private int measure(FleetServer toqa, URI address, StopSignal stop) throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots, seed.value());
    load.run(time.warmUp(), stop, snapshot -> {});
    Map<String, ClearanceJudge> truths = new LinkedHashMap<>();
    FleetMeter meter = new FleetMeter(toqa.fleetClock(), truths);
    GoalRecorder goals = new GoalRecorder(new RoadGraph(toqa.fleet().floors().getFirst().grid()));
    Consumer<FleetSnapshot> watcher = meter::observe;
    List<BodyObservation> observations = new ArrayList<>();
    for (FloorMap floor : toqa.fleet().floors()) {
      ClearanceJudge truth = new ClearanceJudge(floor.grid());
      truths.put(floor.name(), truth);
      observations.add(toqa.observeBodies(floor.name(), truth::judge));
    }
    load.run(time.seconds(), stop, tasks == null ? watcher : watcher.andThen(goals::observe));
    observations.forEach(BodyObservation::close);
    Report report = meter.report();
    if (tasks != null) {
      Files.write(tasks, goals.goals().stream().map(RobotGoals::line).toList());
    }
    new BenchOutput(spec).printReport(report);
    List<String> failures = failures(report, truths, leastPace);
    failures.forEach(new CommandOutput(spec)::printError);
    return failures.isEmpty() ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  /** What is not as it must be, in sentences. */
  static List<String> failures(
      Report report, Map<String, ClearanceJudge> truths, double leastPace) {
    List<String> failures = new ArrayList<>();
    truths.forEach(
        (floor, truth) -> {
          failures.addAll(touches(truth, "on " + floor));
          if (truth.betweenBodies().isEmpty()) {
            failures.add("nothing was seen of where two robots on " + floor + " really were");
          }
        });
    if (report.pace() < leastPace) {
      failures.add("the pace " + report.pace() + " is below " + leastPace);
    }
    return failures;
  }

  private static List<String> touches(ClearanceJudge truth, String where) {
    return Stream.of(truth.betweenBodies(), truth.toWall())
        .flatMap(Optional::stream)
        .filter(Clearance::isTouch)
        .map(touch -> where + ", " + touch)
        .toList();
  }

  private Map<Setting, @Nullable String> settings() {
    Map<Setting, @Nullable String> settings = BenchUser.create().settings(robots, map);
    settings.put(Setting.SPEED, speed.value());
    return settings;
  }
}
