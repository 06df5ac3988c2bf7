package org.toqa.app.bench;

import java.net.URI;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.concurrent.Callable;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.app.bench.meter.MeasuringTime;
import org.toqa.app.bench.meter.ProcessMeter;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.command.StopSignal;
import org.toqa.app.server.FleetServer;
import org.toqa.app.server.ServerOperation;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code toqa bench smoothness}: how evenly the live map moves in a browser. */
@Command(
    name = "smoothness",
    description = "Measure the frames of the live map in a headless Chromium.",
    footer = {
      "",
      "Prints JSON: framesPerSecond, frames (from one frame to the next; maxMs is the",
      "longest) and drawing (from an event to the first picture with it). The robots",
      "drive all the time. Chromium must be installed (Debian, Ubuntu: chromium)."
    })
final class SmoothnessBench implements Callable<Integer> {
  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private SimulatedRobotsOption robots = new SimulatedRobotsOption(100, 1);

  @Mixin private OptionalMapOption map = new OptionalMapOption();

  @Mixin private MeasuringTime time = new MeasuringTime();

  /**
   * @param seconds that were measured
   * @param frames from one frame to the next
   * @param drawing from an event in the page until its first picture was drawn
   * @param pace as in {@link ProcessMeter.Reading}
   */
  private record Report(
      int robots,
      double seconds,
      double framesPerSecond,
      LatencySummary frames,
      LatencySummary drawing,
      double pace) {}

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    robots.check(arguments);
    time.check(arguments);
    Path chromium =
        HeadlessChromium.find().orElseThrow(() -> arguments.invalid(HeadlessChromium.MISSING));
    BenchUser user = BenchUser.create();
    ServerOperation measurement =
        (toqa, address, stop) -> measure(toqa, address, user, chromium, stop);
    return measurement.runIsolated(user.settings(robots.value(), map));
  }

  private int measure(FleetServer toqa, URI address, BenchUser user, Path chromium, StopSignal stop)
      throws Exception {
    TaskLoadGenerator load = TaskLoadGenerator.on(toqa.fleet(), robots.value(), 1);
    String token = TaskApiClients.requestToken(address, user);
    PoseReports reports = new PoseReports(InstantSource.system());
    try (LiveMapPage page = LiveMapPage.open(chromium, address.resolve("map"), token, reports)) {
      load.run(time.warmUp(), stop, snapshot -> {});
      page.reset();
      ProcessMeter meter = new ProcessMeter(toqa.fleetClock());
      load.run(time.seconds(), stop, snapshot -> {});
      page.collect();
      ProcessMeter.Reading reading = meter.read();
      double[] frames = page.frameMillis();
      new BenchOutput(spec)
          .printReport(
              new Report(
                  robots.value(),
                  reading.seconds(),
                  frames.length / reading.seconds(),
                  LatencySummary.of(frames),
                  page.drawing(),
                  reading.pace()));
      return ExitCode.OK;
    }
  }
}
