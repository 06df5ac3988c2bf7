package org.toqa.app.bench;

import java.net.URI;
import java.time.InstantSource;
import java.util.EnumMap;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
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

/** {@code toqa bench web}: how long people wait for pages, and for what robots do to be seen. */
@Command(
    name = "web",
    description = "Watches a whole server with simulated robots by many browsers.",
    footer = {
      "",
      "Prints JSON: pages (requests at the rate that was asked for, each counted from",
      "when it was due; failed: how many were not answered by 200), poses (from when",
      "the server heard of a robot until a browser has the event), eventsSeen by all browsers together, pace (the fleet's",
      "seconds a second; below 1 where the machine cannot keep up) and cores (processor",
      "seconds a second, of the whole process, the browsers included)."
    })
public final class WebBench implements Callable<Integer> {
  private static final String USER = "bench";

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--robots",
      defaultValue = "100",
      paramLabel = "N",
      description = "How many drive, 2 to 500 (default: ${DEFAULT-VALUE}).")
  private int robots;

  @Option(
      names = "--browsers",
      defaultValue = "200",
      paramLabel = "N",
      description = "How many watch live, 1 to 2000 (default: ${DEFAULT-VALUE}).")
  private int browsers;

  @Option(
      names = "--rate",
      defaultValue = "50",
      paramLabel = "N",
      description = "How many pages are asked for a second, 1 to 1000 (default: ${DEFAULT-VALUE}).")
  private int rate;

  @Mixin private MeasuringTime time = new MeasuringTime();

  @Option(
      names = "--map",
      paramLabel = "FILE",
      description = "The floor's map, .yaml or .map (default: the shipped map).")
  private @Nullable String map;

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
    arguments.requireBetween("--robots", robots, 2, 500);
    arguments.requireBetween("--browsers", browsers, 1, 2000);
    arguments.requireBetween("--rate", rate, 1, 1000);
    time.check(arguments);
    String password = UUID.randomUUID().toString();
    ServerOperation measurement = (toqa, address, stop) -> measure(toqa, address, password, stop);
    return measurement.runIsolated(settings(password));
  }

  private int measure(FleetServer toqa, URI address, String password, StopSignal stop)
      throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots, 1);
    String token = TaskApiClients.requestToken(address, USER, password);
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
              robots,
              browsers,
              LatencySummary.of(pages.latencyMillis()),
              pages.failed(),
              LatencySummary.of(streams.poseAgeMillis()),
              streams.events(),
              reading.pace(),
              reading.cores());
      spec.commandLine().getOut().println(JsonMapper.shared().writeValueAsString(report));
      return report.failed() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
    }
  }

  private Map<Setting, @Nullable String> settings(String password) {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.SIMULATE, String.valueOf(robots));
    settings.put(Setting.MAP, map);
    settings.put(Setting.MANAGER, USER + ":" + password);
    return settings;
  }
}
