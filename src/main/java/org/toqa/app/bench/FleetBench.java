package org.toqa.app.bench;

import java.net.URI;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.FleetMeter.Report;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.command.SeedOption;
import org.toqa.app.command.SpeedOption;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Setting;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.ServerOperation;
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
      "smallest distance between the edges of two robots; exits 1 if below 0),",
      "heapBeforeMb and heapAfterMb (memory in use at the start and at the end)."
    })
final class FleetBench implements Callable<Integer> {

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--robots",
      required = true,
      paramLabel = "N",
      description = "Number of robots, 2 to 500.")
  private int robots;

  @Mixin private MeasuringTime time = new MeasuringTime();

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private SpeedOption speed = new SpeedOption();

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--robots", robots, 2, 500);
    time.check(arguments);
    ServerOperation measurement = this::measure;
    return measurement.runIsolated(settings());
  }

  private int measure(FleetServer toqa, URI address, StopSignal stop) throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots, seed.value());
    load.run(time.warmUp(), stop, snapshot -> {});
    FleetMeter meter = new FleetMeter(toqa.fleetClock());
    load.run(time.seconds(), stop, meter::observe);
    Report report = meter.report();
    new CommandOutput(spec).printJson(report);
    return report.nearestMetres() >= 0 ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private Map<Setting, @Nullable String> settings() {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.SIMULATE, String.valueOf(robots));
    settings.put(Setting.SPEED, speed.value());
    settings.put(Setting.MAP, map.file());
    return settings;
  }
}
