package org.toqa.agent;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.access.PairingRequestFile;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ConfigException;
import org.toqa.agent.storage.DataFolder;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** The command line of a robot's daemon. */
@Command(name = "toqa agent", description = "Run the daemon of a robot until it is stopped.")
public final class Main implements Callable<Integer> {

  private static final int FAILED = 1;
  private static final int WRONG_CONFIGURATION = 2;
  private static final long LONGEST_END_SECONDS = 3;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Show this help and exit.")
  @SuppressWarnings("unused") // picocli asks the option, nobody the field
  private boolean help;

  @Option(
      names = "--config",
      paramLabel = "FILE",
      description = "Configuration of the robot; --example prints one that explains every key.")
  private @Nullable Path config;

  @Option(
      names = "--example",
      description =
          "Print a configuration, of a robot with a simulated body on this machine, and exit.")
  private boolean example;

  @Option(
      names = "--pair",
      description =
          "Show a code that pairs the robot with a server within ten minutes; if the daemon is"
              + " already running, it accepts the code and keeps running.")
  private boolean pair;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli
  private CommandSpec spec;

  public static void main(String[] args) {
    System.exit(
        new CommandLine(new Main())
            .setParameterExceptionHandler((e, arguments) -> printError(e))
            .execute(args));
  }

  private static int printError(ParameterException e) {
    String sentence =
        e instanceof UnmatchedArgumentException unknown
            ? "\"%s\" is not known; there are --config, --pair and --example"
                .formatted(unknown.getUnmatched().getFirst())
            : String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    printError(e.getCommandLine(), sentence + " (toqa agent --help lists what there is)");
    return WRONG_CONFIGURATION;
  }

  @Override
  public Integer call() {
    try {
      if (example) {
        printExample();
        return 0;
      }
      if (config == null) {
        throw new ParameterException(
            spec.commandLine(), "Missing required option: '--config=FILE', or '--example'");
      }
      run(AgentConfig.read(config));
      return 0;
    } catch (ConfigException e) {
      return printError(e, WRONG_CONFIGURATION);
    } catch (IOException e) {
      return printError(e, FAILED);
    }
  }

  /** The file that explains every key; it is a configuration that works. */
  private void printExample() throws IOException {
    try (InputStream file = Objects.requireNonNull(Main.class.getResourceAsStream("agent.yaml"))) {
      PrintWriter out = spec.commandLine().getOut();
      out.print(new String(file.readAllBytes(), StandardCharsets.UTF_8));
      out.flush();
    }
  }

  private void run(AgentConfig settings) throws IOException {
    if (pair && DataFolder.isInUse(settings.dataDir())) {
      requestPairing(settings);
    } else {
      runUntilStopped(settings);
    }
  }

  /** The daemon runs already: it need not be stopped. */
  private void requestPairing(AgentConfig settings) throws IOException {
    try {
      printCode(PairingRequestFile.requestPairing(settings.dataDir()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("Interrupted before the daemon had taken the code.", e);
    }
  }

  private void runUntilStopped(AgentConfig settings) throws IOException {
    Daemon daemon = Daemon.open(settings, InstantSource.system(), System.nanoTime(), pair);
    daemon.pairingCode().ifPresent(this::printCode);
    CountDownLatch closed = new CountDownLatch(1);
    try (daemon) {
      RealTimeLoop loop = new RealTimeLoop(daemon, settings.chassis().timeFactor());
      Runtime.getRuntime().addShutdownHook(new Thread(() -> stopAndWait(loop, closed)));
      loop.run();
    } finally {
      closed.countDown();
    }
  }

  private void printCode(String code) {
    spec.commandLine()
        .getErr()
        .println(
            "Pairing code: "
                + code
                + " (good for ten minutes; enter it at the server, page Robots, with this robot's"
                + " address and port)");
  }

  private static void stopAndWait(RealTimeLoop loop, CountDownLatch closed) {
    loop.stop();
    try {
      closed.await(LONGEST_END_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private int printError(Exception e, int exitCode) {
    printError(spec.commandLine(), e.getMessage());
    return exitCode;
  }

  private static void printError(CommandLine command, @Nullable String sentence) {
    command.getErr().println("toqa: " + sentence);
  }
}
