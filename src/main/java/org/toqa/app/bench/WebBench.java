package org.toqa.app.bench;

import java.net.URI;
import java.time.InstantSource;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.OptionalMapOption;
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

/** {@code toqa bench web}: how long people wait for pages, and for what robots do to be seen. */
@Command(
    name = "web",
    description = "Measure the web pages and live events of a server under load.",
    footer = {
      "",
      "Prints JSON: pages (response times of the requests, each counted from when it",
      "was due), failed (responses other than 200; exits 1 if there are any), poses",
      "(from when the server hears from a robot until a browser has the event),",
      "eventsSeen (all browsers together), pace (simulated seconds per second; below 1",
      "if the machine cannot keep up) and cores (processor seconds per second of the",
      "whole process, including the browsers)."
    })
final class WebBench implements Callable<Integer> {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private SimulatedRobotsOption robots = new SimulatedRobotsOption(100, 2);

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Option(
      names = "--browsers",
      defaultValue = "200",
      paramLabel = "N",
      description = "Number of live maps open, 1 to 2000 (default: ${DEFAULT-VALUE}).")
  private int browsers;

  @Option(
      names = "--rate",
      defaultValue = "50",
      paramLabel = "N",
      description = "Page requests per second, 1 to 1000 (default: ${DEFAULT-VALUE}).")
  private int rate;

  @Mixin private MeasuringTime time = new MeasuringTime();

  /**
   * @param pages from when each page was due until it was there
   * @param failed how many pages were not answered with status 200
   * @param poses from when the server heard of a robot until a browser had the event
   * @param eventsSeen by all browsers together
   * @param pace as in {@link ProcessMeter.Reading}
   * @param cores as there
   */
  private record Report(
      int robots,
      int browsers,
      LatencySummary pages,
      int failed,
      LatencySummary poses,
      long eventsSeen,
      double pace,
      double cores) {}

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    robots.check(arguments);
    arguments.requireBetween("--browsers", browsers, 1, 2000);
    arguments.requireBetween("--rate", rate, 1, 1000);
    time.check(arguments);
    BenchUser user = BenchUser.create();
    ServerOperation measurement = (toqa, address, stop) -> measure(toqa, address, user, stop);
    return measurement.runIsolated(settings(user));
  }

  private int measure(FleetServer toqa, URI address, BenchUser user, StopSignal stop)
      throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots.value(), 1);
    String token = TaskApiClients.requestToken(address, user);
    try (LiveStreamClients streams =
            LiveStreamClients.open(address, token, browsers, InstantSource.system());
        PageLoadGenerator pages = PageLoadGenerator.start(address, token, rate)) {
      load.run(time.warmUp(), stop, snapshot -> {});
      streams.reset();
      pages.reset();
      ProcessMeter meter = new ProcessMeter(toqa.fleetClock());
      load.run(time.seconds(), stop, snapshot -> {});
      ProcessMeter.Reading reading = meter.read();
      Report report =
          new Report(
              robots.value(),
              browsers,
              LatencySummary.of(pages.latencyMillis()),
              pages.failed(),
              LatencySummary.of(streams.poseAgeMillis()),
              streams.events(),
              reading.pace(),
              reading.cores());
      new BenchOutput(spec).printReport(report);
      return report.failed() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
    }
  }

  private Map<Setting, @Nullable String> settings(BenchUser user) {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.SIMULATE, String.valueOf(robots.value()));
    settings.put(Setting.MAP, map.file());
    settings.put(Setting.MANAGER, user.setting());
    return settings;
  }
}
