package org.toqa.app.bench;

import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.command.SeedOption;
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

/** {@code toqa bench soak}: what hours of work leave behind. */
@Command(
    name = "soak",
    description = "Let a complete server with simulated robots work for hours.",
    footer = {
      "",
      "Random tasks keep all robots busy, in simulated time.",
      "",
      "Prints JSON: hours (simulated) and seconds (real), tasksDone, waitP50Seconds,",
      "waitP99Seconds and longestWaitSeconds (simulated, from a task's order to its",
      "first robots; there are always half as many more tasks than robots), emptyShare",
      "(the share of their time in which robots had less than 5 %% in their batteries),",
      "chargerUse (the share of their time in which charging points charged), samples",
      "(24 in equal distances, and at the end: tasksDone, databaseMb, what the",
      "database takes, largestMb, the most that its file took since the sample before,",
      "contentMb, what it would take if it were compacted, heapMb, memory in use),",
      "stuck (tasks and robots that did not get on for 30 simulated minutes, and what",
      "they wait for), leavesOut (what is not measured).",
      "",
      "Exits 1 if something is stuck."
    })
final class SoakBench implements Callable<Integer> {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--hours",
      required = true,
      paramLabel = "H",
      description = "Simulated hours, 0 to 1000.")
  private double hours;

  @Option(
      names = "--speed",
      defaultValue = "20",
      paramLabel = "N",
      description =
          "Run simulated time N times faster than real time, if the machine can (default:"
              + " ${DEFAULT-VALUE}).")
  private String speed = "";

  @Mixin private DatabaseOption database = new DatabaseOption();

  @Mixin private SimulatedRobotsOption robots = new SimulatedRobotsOption(12, 1);

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    arguments.requireDecimalBetween("--hours", hours, 0, 1000);
    robots.check(arguments);
    database.check(arguments);
    ServerOperation measurement = this::measure;
    return measurement.runIsolated(settings());
  }

  private int measure(FleetServer toqa, URI address, StopSignal stop) throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots.value(), seed.value());
    Duration length = Duration.ofSeconds(Math.round(hours * 3600));
    SoakMeter meter =
        new SoakMeter(
            toqa.fleetClock(),
            length,
            toqa::databaseSize,
            toqa::databaseFileSize,
            toqa.fleet().floors().getFirst().charging().size());
    Instant end = toqa.fleetClock().instant().plus(length);
    long begin = System.nanoTime();
    load.runUntil(() -> !toqa.fleetClock().instant().isBefore(end), stop, meter::observe);
    SoakMeter.Report report = meter.report((System.nanoTime() - begin) / 1e9);
    new BenchOutput(spec).printReport(report);
    report
        .stuck()
        .forEach(
            stuck ->
                new CommandOutput(spec)
                    .printError(stuck.who() + " does not get on: " + stuck.what()));
    return report.stuck().isEmpty() ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private Map<Setting, @Nullable String> settings() {
    Map<Setting, @Nullable String> settings = BenchUser.create().settings(robots.value(), map);
    settings.put(Setting.SPEED, speed);
    settings.put(Setting.DATABASE_URL, database.value());
    return settings;
  }
}
