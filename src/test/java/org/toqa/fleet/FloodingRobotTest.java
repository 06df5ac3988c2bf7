package org.toqa.fleet;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.joran.JoranConfigurator;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.ConsoleAppender;
import ch.qos.logback.core.OutputStreamAppender;
import ch.qos.logback.core.encoder.Encoder;
import ch.qos.logback.core.joran.spi.JoranException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.Policy;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.LogLevel;

/** One robot that says far too much, over a real socket, beside one that is well. */
@Timeout(120)
class FloodingRobotTest {
  private static final Duration LIMIT = Duration.ofSeconds(30);

  /** For what a person or another robot waits for meanwhile. */
  private static final Duration PROMPT = Duration.ofSeconds(10);

  private static final FloorMap FLOOR =
      new FloorMap(
          "hall",
          OccupancyGrid.parse("..........", ".........."),
          List.of(),
          List.of(new Place("P1", new Vec2(0.5, 0.5)), new Place("P2", new Vec2(8.5, 0.5))),
          List.of());

  private static final String FORGED_LINE = "10:00:00.000 ERROR org.toqa.Forged";

  @TempDir private Path keys;
  private final Database database = MemoryDatabase.open("flood-" + System.nanoTime());
  private final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
  private final AtomicLong sent = new AtomicLong();
  private Peer r1;
  private Peer r2;
  private AgentFleet fleet;
  private volatile boolean floods = true;
  private volatile double r2Battery = 1;
  private Instant now = Instant.parse("2026-11-21T08:00:00Z");

  /** A robot whose lines the test writes. */
  private final class Peer implements AutoCloseable {
    private final String name;
    private final double x;
    private final ServerSocket port = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
    private Socket socket = new Socket();

    Peer(String name, double x) throws IOException {
      this.name = name;
      this.x = x;
      port.setSoTimeout((int) LIMIT.toMillis());
      store.saveRobot(
          RobotRecord.direct(
              name, FLOOR.name(), "127.0.0.1", port.getLocalPort(), 5, null, false, null));
    }

    void greet() throws IOException {
      socket = port.accept();
      Thread.ofVirtual().start(this::drain);
      say(
          """
          {"type":"hello","version":1,"robot":"%s","maxLoad":5.0,"maxSpeed":0.5,"footprint":0.255,\
          "localised":true,"pose":{"x":%s,"y":0.5,"theta":0},"mode":"IDLE","task":null,"phase":0,\
          "role":"ALONE","drive":0,"segment":0,"released":0,"lastSeq":0,"done":null}"""
              .formatted(name, x));
    }

    private void drain() {
      try {
        socket.getInputStream().transferTo(OutputStream.nullOutputStream());
      } catch (IOException e) {
        // the test is over
      }
    }

    String state(double battery, String obstacles, String errors) {
      return """
          {"type":"state","stamp":0,"localised":true,"pose":{"x":%s,"y":0.5,"theta":0},\
          "twist":{"v":0,"w":0},"mode":"IDLE","task":null,"phase":0,"role":"ALONE","drive":0,\
          "segment":0,"released":0,"battery":%s,"ranges":[],"obstacles":[%s],"errors":[%s]}"""
          .formatted(x, battery, obstacles, errors);
    }

    void say(String lines) throws IOException {
      socket.getOutputStream().write((lines + "\n").getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void close() throws IOException {
      socket.close();
      port.close();
    }
  }

  @BeforeEach
  void start() throws IOException {
    r1 = new Peer("r1", 0.5);
    r2 = new Peer("r2", 8.5);
    fleet =
        new AgentFleet(
            FloorsInMemory.of(FLOOR),
            store,
            new JdbiScheduleStore(database.jdbi()),
            new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(keys)), false),
            Policy.OPTIMAL.method(),
            new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, 1),
            InstantSource.system(),
            now);
    r1.greet();
    r2.greet();
    Thread.ofPlatform().daemon().start(() -> repeat(r2, () -> r2.state(r2Battery, "", "")));
  }

  @AfterEach
  void stop() throws IOException {
    floods = false;
    fleet.close();
    r1.close();
    r2.close();
    database.close();
  }

  @Test
  void statesWithoutEndDelayNobodyElseAndNoPause() throws Exception {
    flood(r1.state(0.5, "", ""));
    await(() -> sent.get() > 300_000, LIMIT);

    for (int i = 1; i <= 5; i++) {
      double battery = i / 10.0;
      r2Battery = battery;
      await(() -> Objects.equals(robot("r2").telemetry().battery(), battery), PROMPT);
    }
    long begin = System.nanoTime();
    fleet.pauseAll("Max").toCompletableFuture().get(PROMPT.toSeconds(), TimeUnit.SECONDS);
    assertTrue(System.nanoTime() - begin < PROMPT.toNanos());
    await(() -> history("robot.sends-too-much") == 1, LIMIT);
    assertTrue(fleet.passedOver(RobotMessageKind.STATE) > 100_000);
    r2Battery = 0.9;
    await(() -> Objects.equals(robot("r2").telemetry().battery(), 0.9), PROMPT);

    floods = false;
    await(() -> history("robot.sends-normally") == 1, LIMIT);
    assertEquals(1, history("robot.sends-too-much"));
  }

  @Test
  void endsAndAnswersWithoutEndAreLeftOutAndTheRobotIsStillHeard() throws Exception {
    flood(
        "{\"type\":\"done\",\"task\":null,\"phase\":0,\"drive\":3}\n"
            + "{\"type\":\"reject\",\"seq\":99999,\"reason\":\"No.\"}\n"
            + "{\"type\":\"song\"}\n"
            + r1.state(0.25, "", ""));

    await(() -> history("robot.sends-too-much") >= 2, LIMIT);
    await(() -> Objects.equals(robot("r1").telemetry().battery(), 0.25), PROMPT);
    r2Battery = 0.75;
    await(() -> Objects.equals(robot("r2").telemetry().battery(), 0.75), PROMPT);
    fleet.pauseAll("Max").toCompletableFuture().get(PROMPT.toSeconds(), TimeUnit.SECONDS);
  }

  @Test
  void obstaclesFartherThanTheSensorsSeeAreNotBelieved() throws Exception {
    r1.say(r1.state(0.3, "{\"x\":5.5,\"y\":1.5},{\"x\":8.5,\"y\":0.5},{\"x\":1.5,\"y\":1.5}", ""));
    await(() -> Objects.equals(robot("r1").telemetry().battery(), 0.3), LIMIT);
    await(
        () -> !fleet.snapshots().latest().floors().getFirst().obstacles().equals(CellRuns.NONE),
        LIMIT);

    BitSet near = new BitSet();
    near.set(FLOOR.grid().index(FLOOR.grid().cellAt(new Vec2(1.5, 1.5))));
    assertEquals(CellRuns.of(near), fleet.snapshots().latest().floors().getFirst().obstacles());
    assertEquals(2, fleet.passedOver(RobotMessageKind.OBSTACLE));
  }

  /** By the pattern of logback.xml, and as a robot would forge it. */
  @Test
  void aRobotWritesNoLinesOfTheLog() throws Exception {
    Logger root = (Logger) LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    OutputStreamAppender<ILoggingEvent> appender = new OutputStreamAppender<>();
    appender.setContext(root.getLoggerContext());
    appender.setEncoder(shippedEncoder());
    appender.setOutputStream(written);
    appender.start();
    root.addAppender(appender);
    try (LogLevel _ = LogLevel.usual("org.toqa.fleet");
        LogLevel _ = LogLevel.usual("test")) {
      String forged = "\\n" + FORGED_LINE + "\\u001b[2J\\u202e\\u2028";
      r1.say("{\"type\":\"reject\",\"seq\":7,\"reason\":\"" + forged + "\"}");
      r1.say("{\"type\":\"" + forged + "\"}");
      r1.say(r1.state(0.3, "", "{\"code\":\"X" + forged + "\",\"text\":\"" + forged + "\"}"));
      await(() -> !robot("r1").telemetry().errors().isEmpty(), LIMIT);
      await(() -> written.toString(StandardCharsets.UTF_8).contains("refused command 7"), LIMIT);
      String lines = String.join("\n", "two", FORGED_LINE);
      LoggerFactory.getLogger("test").warn("of {}", lines, new IOException(lines));
    } finally {
      root.detachAppender(appender);
    }

    String log = written.toString(StandardCharsets.UTF_8);
    assertTrue(log.contains(FORGED_LINE), log);
    assertFalse(log.lines().anyMatch(line -> line.startsWith(FORGED_LINE)), log);
    assertFalse(log.contains("\u001b") || log.contains("\u202e") || log.contains("\u2028"), log);
    robot("r1")
        .telemetry()
        .errors()
        .forEach(
            fault ->
                assertFalse(
                    (fault.code() + fault.text()).matches("(?s).*[\\p{Cntrl}\u202e\u2028].*")));
  }

  /** As logback.xml has it, whatever other tests did with the log of this process. */
  private static Encoder<ILoggingEvent> shippedEncoder() throws JoranException {
    LoggerContext context = new LoggerContext();
    JoranConfigurator configurator = new JoranConfigurator();
    configurator.setContext(context);
    configurator.doConfigure(requireNonNull(FloodingRobotTest.class.getResource("/logback.xml")));
    Logger root = context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    return ((ConsoleAppender<ILoggingEvent>) root.getAppender("STDERR")).getEncoder();
  }

  private void flood(String lines) {
    byte[] many = (lines + "\n").repeat(200).getBytes(StandardCharsets.UTF_8);
    Thread.ofPlatform()
        .daemon()
        .start(
            () -> {
              try {
                OutputStream out = r1.socket.getOutputStream();
                while (floods) {
                  out.write(many);
                  sent.addAndGet(200);
                }
              } catch (IOException e) {
                return; // the link or the test is over
              }
              repeat(r1, () -> r1.state(0.5, "", ""));
            });
  }

  /** As a robot that is well. */
  private static void repeat(Peer robot, Supplier<String> line) {
    try {
      while (!robot.port.isClosed()) {
        robot.say(line.get());
        TimeUnit.MILLISECONDS.sleep(200);
      }
    } catch (IOException | InterruptedException e) {
      // the link or the test is over
    }
  }

  private RobotView robot(String name) {
    return fleet.snapshots().latest().robots().stream()
        .filter(robot -> robot.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private long history(String kind) {
    return database
        .jdbi()
        .withHandle(
            h ->
                h.createQuery("select count(*) from events where kind = :kind")
                    .bind("kind", kind)
                    .mapTo(Long.class)
                    .one());
  }

  private void await(BooleanSupplier condition, Duration limit) throws InterruptedException {
    long end = System.nanoTime() + limit.toNanos();
    while (fleet.snapshots().latest().robots().size() < 2 || !condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "it is still so: " + fleet.snapshots().latest());
      now = now.plusMillis(500);
      fleet.tick(now);
      fleet.snapshots().awaitNewer(fleet.snapshots().latest().version(), Duration.ofMillis(20));
    }
  }
}
