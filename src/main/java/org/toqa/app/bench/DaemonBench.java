package org.toqa.app.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.app.bench.meter.MeasuredSeconds;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.TemporaryFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * {@code ./toqa bench daemon}: memory and processor time of a robot's daemon, and how regularly a
 * leader sends its pose.
 */
@Command(
    name = "daemon",
    description = "Measure a robot's daemon, idle and leading a follower.",
    footer = {
      "",
      "Starts the daemon with a simulated chassis, measures it for S seconds while",
      "idle and for S seconds while it leads a follower.",
      "",
      "Prints JSON: startMs (until it listens), megabytes (resident memory at the",
      "end), standingCore and drivingCore (processor seconds per second), and offBeat",
      "(deviation of each of the leader's poses from 200 ms after the previous one)."
    })
final class DaemonBench implements Callable<Integer> {
  /** Set by the launcher, which builds it. */
  private static final String AGENT_JAR_PROPERTY = "toqa.agent";

  private static final Duration SETTLING_TIME = Duration.ofSeconds(5);

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private MeasuredSeconds seconds = new MeasuredSeconds();

  @Option(
      names = "--busy",
      defaultValue = "0",
      paramLabel = "N",
      description =
          "Number of busy threads beside the daemon, 0 to 64 (default: ${DEFAULT-VALUE}).")
  private int busyThreads;

  /**
   * @param startMs until it listens, milliseconds
   * @param megabytes resident memory at the end, in units of 2^20 bytes; null where the system does
   *     not tell
   * @param standingCore processor seconds a second, idle
   * @param drivingCore the same while it leads a follower
   * @param offBeat how far each of the leader's poses came from 200 ms after the one before
   */
  private record Report(
      double startMs,
      @Nullable Double megabytes,
      double standingCore,
      double drivingCore,
      LatencySummary offBeat) {}

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    seconds.check(arguments);
    arguments.requireBetween("--busy", busyThreads, 0, 64);
    List<Thread> others = startBusyThreads();
    try (TemporaryFolder folder = TemporaryFolder.create("toqa-bench");
        MeasuredDaemon daemon = MeasuredDaemon.start(agentJar(arguments), folder.path());
        DaemonPeers peers = DaemonPeers.of(daemon)) {
      Report report = measure(daemon, peers);
      new BenchOutput(spec).printReport(report);
      return ExitCode.OK;
    } finally {
      others.forEach(Thread::interrupt);
    }
  }

  private static Path agentJar(Arguments arguments) {
    String jar = System.getProperty(AGENT_JAR_PROPERTY);
    if (jar == null || !Files.isReadable(Path.of(jar))) {
      throw arguments.invalid("The daemon is missing: run ./toqa bench daemon, which builds it");
    }
    return Path.of(jar);
  }

  private List<Thread> startBusyThreads() {
    List<Thread> threads = new ArrayList<>();
    for (int i = 0; i < busyThreads; i++) {
      threads.add(
          Thread.ofPlatform()
              .daemon()
              .start(
                  () -> {
                    while (!Thread.currentThread().isInterrupted()) {
                      Thread.onSpinWait();
                    }
                  }));
    }
    return threads;
  }

  private Report measure(MeasuredDaemon daemon, DaemonPeers peers)
      throws IOException, InterruptedException {
    Thread.sleep(SETTLING_TIME);
    double standing = processorShare(daemon);
    peers.startDriving();
    Thread.sleep(SETTLING_TIME);
    peers.reset();
    double driving = processorShare(daemon);
    peers.requireNoRefusals();
    return new Report(
        daemon.startMillis(),
        daemon.megabytes().orElse(null),
        standing,
        driving,
        LatencySummary.of(peers.poseJitterMillis()));
  }

  /** Processor seconds a second, over the time that is measured. */
  private double processorShare(MeasuredDaemon daemon) throws InterruptedException {
    Duration before = daemon.processorTime();
    long began = System.nanoTime();
    Thread.sleep(Duration.ofSeconds(seconds.value()));
    double taken = daemon.processorTime().minus(before).toNanos();
    return taken / (System.nanoTime() - began);
  }
}
