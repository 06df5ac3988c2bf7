package org.toqa.app.robot;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.PlaceArgument;
import org.toqa.app.command.StopSignal;
import org.toqa.geometry.Pose;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Identity;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.PrivateFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa http-robot}: until it is told to end. */
@Command(
    name = "http-robot",
    description = "Be a robot with a simulated body that takes wheel commands over HTTP.",
    footer = {
      "",
      "It listens until Ctrl-C, and says where. A manager adds it on the page Robots,",
      "as one with wheel commands over HTTP, and then says where it stands.",
      "docs/http-robot.md tells what it is told and answers, for whoever builds a real",
      "one."
    })
public final class HttpRobotCommand implements Callable<Integer> {
  private static final String TOKEN_VARIABLE = "TOQA_ROBOT_TOKEN";

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--address",
      paramLabel = "A",
      defaultValue = "127.0.0.1",
      description = "Listen on this address of this machine (default: ${DEFAULT-VALUE}).")
  private String address = "";

  @Option(
      names = "--port",
      paramLabel = "P",
      defaultValue = "7280",
      description = "Listen on this port of TCP; 0 for any free one (default: ${DEFAULT-VALUE}).")
  private int port;

  @Option(
      names = "--token",
      paramLabel = "T",
      description =
          "What the server must send, 16 to 128 letters, digits and signs; else from the variable "
              + TOKEN_VARIABLE
              + ", else one is made and shown.")
  private @Nullable String token;

  @Option(
      names = "--data",
      paramLabel = "DIR",
      description =
          "Keep the body, and the key of --tls, in this folder; without it a body begins anew,"
              + " as after a loss of power.")
  private @Nullable Path data;

  @Option(names = "--tls", description = "Encrypt, and show the certificate's fingerprint.")
  private boolean isEncrypted;

  @Option(
      names = "--start",
      paramLabel = "X,Y[,DEG]",
      defaultValue = "0,0",
      converter = PlaceArgument.PoseConverter.class,
      description = "Where a new body really is, metres and degrees (default: ${DEFAULT-VALUE}).")
  @SuppressWarnings("NullAway.Init") // set by picocli
  private PlaceArgument start;

  @Option(
      names = "--max-load",
      paramLabel = "KG",
      defaultValue = "5",
      description = "What it carries, 0 to 10000 kg (default: ${DEFAULT-VALUE}).")
  private double maxLoad;

  @Option(
      names = "--slip",
      paramLabel = "S",
      defaultValue = "0.01",
      description =
          "Standard deviation of a wheel's slip, 0 to 0.5 of what it turns"
              + " (default: ${DEFAULT-VALUE}).")
  private double slip;

  @Option(
      names = "--size-error",
      paramLabel = "S",
      defaultValue = "0",
      description =
          "Standard deviation of a wheel's constant error in size, 0 to 0.1 of it"
              + " (default: ${DEFAULT-VALUE}).")
  private double sizeError;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Of the randomness (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--delay",
      paramLabel = "MS",
      defaultValue = "0",
      description = "Answer so late, 0 to 1000 ms (default: ${DEFAULT-VALUE}).")
  private int delay;

  @Override
  public Integer call() throws Exception {
    Arguments arguments = new Arguments(spec);
    arguments.requireBetween("--port", port, 0, 65_535);
    arguments.requireBetween("--delay", delay, 0, 1000);
    arguments.requireDecimalBetween("--max-load", maxLoad, 0, 10_000);
    requireShare(arguments, "--slip", slip, 0.5);
    requireShare(arguments, "--size-error", sizeError, 0.1);
    if (isEncrypted && data == null) {
      throw arguments.invalid("--tls needs --data, where its key is kept");
    }
    SimulatedHttpRobot.Settings settings =
        new SimulatedHttpRobot.Settings(
            address(arguments),
            port,
            token(arguments),
            isEncrypted && data != null ? tls(data) : null,
            data,
            startPose(),
            slip,
            sizeError,
            seed,
            maxLoad,
            Duration.ofMillis(delay),
            List.of(),
            null);
    try (StopSignal stop = new StopSignal();
        SimulatedHttpRobot robot = new SimulatedHttpRobot(settings)) {
      System.err.println("Listening on " + address + " port " + robot.port() + ".");
      stop.await();
      return ExitCode.OK;
    }
  }

  private static void requireShare(Arguments arguments, String option, double value, double most) {
    if (!(value >= 0 && value <= most)) {
      throw arguments.invalid(option + " " + value + ": it must be from 0 to " + most);
    }
  }

  private InetAddress address(Arguments arguments) {
    try {
      return InetAddress.getByName(address);
    } catch (UnknownHostException e) {
      throw arguments.invalid("--address " + address + " is no address of this machine");
    }
  }

  /** It is shown only where nobody else knows it. */
  private RobotToken token(Arguments arguments) {
    String given = token == null ? System.getenv(TOKEN_VARIABLE) : token;
    if (given == null) {
      RobotToken made = RobotToken.random();
      System.err.println("The token of this robot is " + made.secret());
      return made;
    }
    Optional<RobotToken> parsed = RobotToken.parse(given);
    return parsed.orElseThrow(
        () ->
            arguments.invalid("A token has 16 to 128 letters, digits and the signs - . _ ~ + / ="));
  }

  private static Identity tls(Path folder) throws IOException {
    PrivateFolder.create(folder);
    Identity tls = IdentityFile.open(folder);
    System.err.println("The fingerprint of this robot's certificate is " + tls.fingerprint());
    return tls;
  }

  private Pose startPose() {
    Double heading = start.heading();
    return new Pose(start.position().x(), start.position().y(), heading == null ? 0 : heading);
  }
}
