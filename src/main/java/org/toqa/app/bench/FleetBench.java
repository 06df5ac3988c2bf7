package org.toqa.app.bench;

import java.net.URI;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.FleetMeter.Report;
import org.toqa.app.command.Arguments;
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
import tools.jackson.databind.json.JsonMapper;

/** {@code toqa bench fleet}: what a whole fleet costs that always has something to carry. */
@Command(
    name = "fleet",
    description = "Runs a whole server with simulated robots.",
    footer = {
      "",
      "Prints JSON: pace (the fleet's seconds a second; below 1 where the machine",
      "cannot keep up), cores (processor seconds a second, of the whole process),",
      "metresDriven and tasksDone by all robots together, nearestMetres (the least",
      "that two robots' edges were ever apart; below 0 it exits 1), and heapBeforeMb",
      "and heapAfterMb (what is in use at the begin and at the end)."
    })
public final class FleetBench implements Callable<Integer> {

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--robots",
      required = true,
      paramLabel = "N",
      description = "How many, 2 to 500.")
  private int robots;

  @Mixin private MeasuringTime time = new MeasuringTime();

  @Option(
      names = "--seed",
      defaultValue = "1",
      paramLabel = "S",
      description = "Of starts and goals (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--speed",
      defaultValue = "1",
      paramLabel = "N",
      description = "How many times faster than real time (default: ${DEFAULT-VALUE}).")
  private String speed = "1";

  @Option(
      names = "--map",
      paramLabel = "FILE",
      description = "The floor's map, .yaml or .map (default: the shipped map).")
  private @Nullable String map;

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--robots", robots, 2, 500);
    time.check(arguments);
    ServerOperation measurement = this::measure;
    return measurement.runIsolated(settings());
  }

  private int measure(FleetServer toqa, URI address, StopSignal stop) throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots, seed);
    load.run(time.warmUp(), stop, snapshot -> {});
    FleetMeter meter = new FleetMeter(toqa.fleetClock());
    load.run(time.seconds(), stop, meter::observe);
    Report report = meter.report();
    spec.commandLine().getOut().println(JsonMapper.shared().writeValueAsString(report));
    return report.nearestMetres() >= 0 ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private Map<Setting, @Nullable String> settings() {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.SIMULATE, String.valueOf(robots));
    settings.put(Setting.SPEED, speed);
    settings.put(Setting.MAP, map);
    return settings;
  }
}
