package org.toqa.app.bench;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.app.bench.meter.MeasuringTime;
import org.toqa.app.bench.meter.ProcessMeter;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.command.StopSignal;
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
      "was due), failed (responses other than 200; exits 1 if there are any), the way",
      "of a pose from the robot's report: heard (until the server hears it), poses",
      "(from there until a browser has the event), seen (both together), drawing (in",
      "Chromium, from the event to the first picture with it) and drawn (from the",
      "robot's report to that picture), unmatched (poses seen that no robot has",
      "reported lately), eventsSeen (all browsers together), pace (simulated seconds",
      "per second; below 1 if the machine cannot keep up) and cores (processor seconds",
      "per second of the whole process, including the browsers but Chromium)."
    })
final class WebBench implements Callable<Integer> {
  private static final int COLLECTING_SECONDS = 5;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private SimulatedRobotsOption robots = new SimulatedRobotsOption(100, 2);

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Option(
      names = "--browsers",
      defaultValue = "200",
      paramLabel = "N",
      description =
          "Number of live maps open, 1 to 2000 (default: ${DEFAULT-VALUE}); one of them in"
              + " Chromium, if that is installed.")
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
   * @param heard from a robot's report until the server heard it
   * @param poses from when the server heard of a robot until a browser had the event
   * @param seen from a robot's report until a browser had it
   * @param drawing from an event in Chromium until its picture was drawn; null without Chromium
   * @param drawn from a robot's report until the picture with it was drawn; null as well
   * @param unmatched how many poses were seen that no robot has reported
   * @param eventsSeen by all browsers together
   * @param pace as in {@link ProcessMeter.Reading}
   * @param cores as there
   */
  private record Report(
      int robots,
      int browsers,
      LatencySummary pages,
      int failed,
      LatencySummary heard,
      LatencySummary poses,
      LatencySummary seen,
      @Nullable LatencySummary drawing,
      @Nullable LatencySummary drawn,
      long unmatched,
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
    return measurement.runIsolated(user.settings(robots.value(), map));
  }

  private int measure(FleetServer toqa, URI address, BenchUser user, StopSignal stop)
      throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots.value(), 1);
    String token = TaskApiClients.requestToken(address, user);
    InstantSource clock = InstantSource.system();
    PoseReports reports = new PoseReports(clock);
    toqa.observeReports(reports::add);
    PoseLatencies latencies = new PoseLatencies(reports);
    try (LiveMapPage map = openMap(address, token, reports);
        LiveStreamClients streams =
            LiveStreamClients.open(
                address, token, map == null ? browsers : browsers - 1, latencies, clock);
        PageLoadGenerator pages = PageLoadGenerator.start(address, token, rate)) {
      run(load, time.warmUp(), map, stop);
      streams.reset();
      latencies.reset();
      pages.reset();
      if (map != null) {
        map.reset();
      }
      ProcessMeter meter = new ProcessMeter(toqa.fleetClock());
      run(load, time.seconds(), map, stop);
      ProcessMeter.Reading reading = meter.read();
      PoseLatencies.Summary poses = latencies.summary();
      Report report =
          new Report(
              robots.value(),
              browsers,
              LatencySummary.of(pages.latencyMillis()),
              pages.failed(),
              poses.heard(),
              poses.streamed(),
              poses.seen(),
              map == null ? null : map.drawing(),
              map == null ? null : map.drawn(),
              poses.unmatched(),
              streams.events(),
              reading.pace(),
              reading.cores());
      new BenchOutput(spec).printReport(report);
      return report.failed() == 0 ? ExitCode.OK : ExitCode.SOFTWARE;
    }
  }

  /** Null, with a word why, where there is no Chromium. */
  private @Nullable LiveMapPage openMap(URI address, String token, PoseReports reports)
      throws IOException, InterruptedException {
    Optional<Path> chromium = HeadlessChromium.find();
    if (chromium.isEmpty()) {
      new CommandOutput(spec)
          .printError(
              "no picture is drawn, drawing and drawn are null: " + HeadlessChromium.MISSING);
      return null;
    }
    return LiveMapPage.open(chromium.get(), address.resolve("map"), token, reports);
  }

  /** In parts, after each of which the map tells what it has drawn. */
  private static void run(
      TaskLoadGenerator load, int seconds, @Nullable LiveMapPage map, StopSignal stop)
      throws Exception {
    for (int left = seconds; left > 0; left -= COLLECTING_SECONDS) {
      load.run(Math.min(left, COLLECTING_SECONDS), stop, snapshot -> {});
      if (map != null) {
        map.collect();
      }
    }
  }
}
