package org.toqa.app.robot;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import com.sun.net.httpserver.HttpsServer;
import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Pose;
import org.toqa.link.http.HttpRobotCodec;
import org.toqa.link.http.HttpRobotException;
import org.toqa.link.http.RobotDescription;
import org.toqa.link.http.RobotToken;
import org.toqa.link.http.WheelReport;
import org.toqa.link.http.WheelReport.RobotError;
import org.toqa.link.trust.HttpTls;
import org.toqa.link.trust.Identity;
import tools.jackson.databind.json.JsonMapper;

/** A simulated body behind the HTTP of {@code docs/http-robot.md}. */
public final class SimulatedHttpRobot implements AutoCloseable {
  static {
    // The server of the JDK waits 40 ms with each answer otherwise, for more to send.
    System.setProperty("sun.net.httpserver.nodelay", "true");
  }

  private static final JsonMapper MAPPER = new JsonMapper();
  private static final Duration SILENCE = Duration.ofMinutes(1);
  private static final RobotError EMERGENCY =
      new RobotError("EMERGENCY", "The emergency stop is pressed.");
  private static final int OK = 200;
  private static final int BAD_REQUEST = 400;
  private static final int UNAUTHORIZED = 401;
  private static final int NOT_FOUND = 404;
  private static final int METHOD_NOT_ALLOWED = 405;

  private final RobotToken token;
  private final SimulatedHttpBody body;
  private final HttpServer server;
  private final ExecutorService handlers;
  private volatile Duration delay;
  private volatile Fault fault = Fault.NONE;
  private volatile boolean isFirst;

  /** Fault switches: what is wrong with the answers to orders, which are obeyed all the same. */
  public enum Fault {
    NONE,
    /** There is none. */
    SILENT,
    /** There is one after each question what it is, and then none. */
    SILENT_AFTER_FIRST,
    /** They are no JSON. */
    NONSENSE,
    /** They are longer than allowed. */
    TOO_LONG,
    /** Ranges that no sensor tells. */
    WRONG_RANGES,
    /** Counts have jumped by a hundred turns. */
    JUMPED_COUNTS,
    /** They tell an emergency stop. */
    EMERGENCY,
    /** They have the status 500. */
    BROKEN
  }

  /**
   * What a robot is started with.
   *
   * @param port of TCP; 0 for any free one
   * @param token that it wants of the server
   * @param tls its key and certificate; null: it does not encrypt
   * @param folder of its body; null: nothing outlives the process
   * @param start where a new body is, map frame
   * @param slip standard deviation of a wheel's slip, as a share of what it turns
   * @param sizeError standard deviation of a wheel's constant error in size, as a share of it
   * @param maxLoad kilograms
   * @param delay with which it answers orders
   * @param rangeAngles where range sensors on its rim look, radians, from right to left; empty: it
   *     has none
   * @param sonar that it tells of; null: none
   */
  public record Settings(
      InetAddress address,
      int port,
      RobotToken token,
      @Nullable Identity tls,
      @Nullable Path folder,
      Pose start,
      double slip,
      double sizeError,
      long seed,
      double maxLoad,
      Duration delay,
      List<Double> rangeAngles,
      RobotDescription.@Nullable Sonar sonar) {

    /** On a free port of loopback, with an exact body that is not kept, which answers at once. */
    public static Settings of(RobotToken token, Pose start) {
      return new Settings(
          InetAddress.getLoopbackAddress(),
          0,
          token,
          null,
          null,
          start,
          0,
          0,
          1,
          5,
          Duration.ZERO,
          List.of(),
          null);
    }
  }

  /**
   * Listens.
   *
   * @throws IOException the port or the folder cannot be used; with a sentence for people
   */
  public SimulatedHttpRobot(Settings settings) throws IOException {
    this(settings, Surroundings.EMPTY);
  }

  /**
   * The same in a world.
   *
   * @param surroundings is told where the body really is
   */
  public SimulatedHttpRobot(Settings settings, Surroundings surroundings) throws IOException {
    this(settings, surroundings, System::nanoTime);
  }

  /**
   * The same by another clock than the machine's.
   *
   * @param nanos does not jump back
   */
  public SimulatedHttpRobot(Settings settings, Surroundings surroundings, LongSupplier nanos)
      throws IOException {
    token = settings.token();
    delay = settings.delay();
    body =
        new SimulatedHttpBody(
            settings.folder(),
            settings.start(),
            settings.slip(),
            settings.sizeError(),
            settings.seed(),
            settings.maxLoad(),
            settings.rangeAngles(),
            settings.sonar(),
            surroundings,
            nanos);
    InetSocketAddress address = new InetSocketAddress(settings.address(), settings.port());
    try {
      server = server(address, settings.tls());
    } catch (BindException e) {
      body.close();
      throw new IOException(
          "The port " + settings.port() + " is taken; give another one by --port.", e);
    }
    handlers = Executors.newVirtualThreadPerTaskExecutor();
    server.setExecutor(handlers);
    server.createContext("/", this::handle);
    server.start();
  }

  private static HttpServer server(InetSocketAddress address, @Nullable Identity tls)
      throws IOException {
    if (tls == null) {
      return HttpServer.create(address, 0);
    }
    HttpsServer encrypted = HttpsServer.create(address, 0);
    encrypted.setHttpsConfigurator(HttpTls.configurator(tls));
    return encrypted;
  }

  /** The port of TCP on which it listens. */
  public int port() {
    return server.getAddress().getPort();
  }

  /** Where the body really is, map frame. */
  public Pose truePose() {
    return body.truePose();
  }

  /** Fault switch: see {@link Fault}. */
  public void setFault(Fault now) {
    fault = now;
  }

  /** Fault switch: the delay with which it answers orders. */
  public void setDelay(Duration now) {
    delay = now;
  }

  private void handle(HttpExchange exchange) throws IOException {
    try (exchange) {
      byte[] asked = exchange.getRequestBody().readNBytes(HttpRobotCodec.MOST_BYTES + 1);
      String authorization = exchange.getRequestHeaders().getFirst("Authorization");
      if (authorization == null || !token.isIn(authorization)) {
        exchange.getResponseHeaders().set("WWW-Authenticate", "Bearer");
        refuse(exchange, UNAUTHORIZED, "the token is missing or wrong");
        return;
      }
      String method = exchange.getRequestMethod();
      String path = exchange.getRequestURI().getPath();
      switch (method + " " + path) {
        case "GET /v1/robot" -> {
          isFirst = true;
          send(exchange, OK, HttpRobotCodec.encode(body.description()));
        }
        case "POST /v1/wheels" -> turnWheels(exchange, asked);
        default -> {
          if (path.equals("/v1/robot") || path.equals("/v1/wheels")) {
            refuse(exchange, METHOD_NOT_ALLOWED, method + " is not for this path");
          } else {
            refuse(exchange, NOT_FOUND, "there is no such path");
          }
        }
      }
    }
  }

  private void turnWheels(HttpExchange exchange, byte[] asked) throws IOException {
    WheelReport report;
    try {
      report = body.obey(HttpRobotCodec.decodeOrder(asked));
    } catch (HttpRobotException e) {
      refuse(exchange, BAD_REQUEST, String.valueOf(e.getMessage()));
      return;
    }
    try {
      Thread.sleep(delay);
      answer(exchange, report);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // it is being closed
    }
  }

  private void answer(HttpExchange exchange, WheelReport report)
      throws IOException, InterruptedException {
    byte[] usual = HttpRobotCodec.encode(report);
    boolean first = isFirst;
    isFirst = false;
    switch (fault) {
      case NONE -> send(exchange, OK, usual);
      case SILENT -> Thread.sleep(SILENCE);
      case SILENT_AFTER_FIRST -> {
        if (!first) {
          Thread.sleep(SILENCE);
        }
        send(exchange, OK, usual);
      }
      case NONSENSE -> send(exchange, OK, "<p>Hello</p>".getBytes(StandardCharsets.UTF_8));
      case TOO_LONG -> send(exchange, OK, new byte[HttpRobotCodec.MOST_BYTES + 1]);
      case WRONG_RANGES ->
          send(
              exchange,
              OK,
              new String(usual, StandardCharsets.UTF_8)
                  .replaceFirst("}$", ",\"ranges\":[0.5,-3,0.5]}")
                  .getBytes(StandardCharsets.UTF_8));
      case JUMPED_COUNTS ->
          send(
              exchange,
              OK,
              HttpRobotCodec.encode(with(report, report.left() + 280_800, List.of())));
      case EMERGENCY ->
          send(
              exchange, OK, HttpRobotCodec.encode(with(report, report.left(), List.of(EMERGENCY))));
      case BROKEN -> refuse(exchange, 500, "it is broken");
    }
  }

  private static WheelReport with(WheelReport report, long left, List<RobotError> errors) {
    return new WheelReport(
        report.seq(),
        report.boot(),
        report.stamp(),
        left,
        report.right(),
        report.battery(),
        report.ranges(),
        errors);
  }

  private static void refuse(HttpExchange exchange, int status, String sentence)
      throws IOException {
    send(
        exchange,
        status,
        MAPPER.writeValueAsBytes(MAPPER.createObjectNode().put("error", sentence)));
  }

  private static void send(HttpExchange exchange, int status, byte[] json) throws IOException {
    exchange.getResponseHeaders().set("Content-Type", "application/json");
    exchange.sendResponseHeaders(status, json.length);
    exchange.getResponseBody().write(json);
  }

  @Override
  public void close() {
    server.stop(0);
    handlers.shutdownNow();
    body.close();
  }
}
