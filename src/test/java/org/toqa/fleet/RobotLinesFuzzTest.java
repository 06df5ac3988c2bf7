package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;
import org.toqa.allocation.Policy;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.FuzzRun;
import org.toqa.testbed.LineFuzzer;
import org.toqa.testbed.LogLevel;

/**
 * A robot that says anything, over a real socket, to a server with its agents and its store: no
 * agent fails, and what the robot says rightly is still understood.
 */
class RobotLinesFuzzTest {

  private static final int LINES_AT_ONCE = 100;
  private static final Path GOLDEN = Path.of("src/test/resources/org/toqa/link/message");
  private static final Duration LIMIT = Duration.ofSeconds(20);

  private static final FloorMap FLOOR =
      new FloorMap(
          "hall",
          OccupancyGrid.parse(".....", "....."),
          List.of(),
          List.of(new Place("P1", new Vec2(0.5, 0.5))),
          List.of());

  @TempDir private Path keys;
  private final LineFuzzer fuzzer = new LineFuzzer(FuzzRun.SEED);
  private final ListAppender<ILoggingEvent> failures = new ListAppender<>();
  private final Logger log = (Logger) LoggerFactory.getLogger(Logger.ROOT_LOGGER_NAME);
  private final LogLevel ofLink = LogLevel.errors("org.toqa.link");
  private final LogLevel ofFleet = LogLevel.errors("org.toqa.fleet");
  private final Database database = MemoryDatabase.open("fuzz-" + System.nanoTime());
  private ServerSocket robot;
  private AgentFleet fleet;
  private Instant now = Instant.parse("2026-11-21T08:00:00Z");

  @BeforeEach
  void start() throws IOException {
    failures.start();
    log.addAppender(failures);
    robot = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
    robot.setSoTimeout((int) LIMIT.toMillis());
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    store.saveRobot(
        RobotRecord.direct(
            "r1", FLOOR.name(), "127.0.0.1", robot.getLocalPort(), 5, "P1", false, null));
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
  }

  @AfterEach
  void stop() throws IOException {
    fleet.close();
    robot.close();
    database.close();
    ofLink.close();
    ofFleet.close();
    log.detachAppender(failures);
  }

  @Test
  void noLineOfARobotHarmsTheServer() throws Exception {
    List<byte[]> correct =
        Files.readAllLines(GOLDEN.resolve("agent.golden")).stream()
            .map(line -> line.getBytes(StandardCharsets.UTF_8))
            .toList();
    long begin = System.nanoTime();
    long lines = 0;
    long understood = 0;
    try (Socket socket = robot.accept()) {
      answerCommands(socket);
      say(socket, correct.get(1)); // a hello of a robot that is idle
      say(socket, new byte[] {'\n'});
      while (lines < FuzzRun.INPUTS) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (int i = 0; i < LINES_AT_ONCE; i++) {
          byte[] line = fuzzer.next(correct);
          understood += isUnderstood(line) ? 1 : 0;
          all.writeBytes(line);
          all.write('\n');
        }
        lines += LINES_AT_ONCE;
        double battery = lines / LINES_AT_ONCE % 1_000 / 1e3;
        all.writeBytes(LinkCodec.encode(standing(battery)));
        say(socket, all.toByteArray());
        awaitBattery(battery);
      }
    }

    assertEquals(List.of(), failures.list.stream().filter(RobotLinesFuzzTest::isFailure).toList());
    assertTrue(understood > lines / 4 && understood < 3 * lines / 4, understood + " understood");
    FuzzRun.tell("the server", lines, "%,d could be read".formatted(understood), begin);
  }

  private static boolean isUnderstood(byte[] line) {
    return line.length < LinkCodec.MAX_LINE_BYTES
        && LinkCodec.decodeAgentMessage(new LineReader.Text(line)) instanceof Decoded;
  }

  private static boolean isFailure(ILoggingEvent event) {
    return event.getLevel().isGreaterOrEqual(Level.ERROR);
  }

  private void awaitBattery(double battery) throws InterruptedException {
    long end = System.nanoTime() + LIMIT.toNanos();
    FleetSnapshot view = fleet.snapshots().latest();
    while (view.robots().stream()
        .noneMatch(r -> Objects.equals(r.telemetry().battery(), battery))) {
      assertTrue(System.nanoTime() < end, "the server hears no more, seed " + FuzzRun.SEED);
      now = now.plusMillis(100);
      fleet.tick(now);
      view = fleet.snapshots().awaitNewer(view.version(), Duration.ofMillis(20));
    }
  }

  /** A robot that does not read is left, and one that answers nothing is connected anew. */
  private static void answerCommands(Socket socket) {
    Thread.ofVirtual()
        .start(
            () -> {
              try (BufferedReader lines =
                  new BufferedReader(
                      new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
                for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                  LineReader.Line read = new LineReader.Text(line.getBytes(StandardCharsets.UTF_8));
                  if (LinkCodec.decodeServerMessage(read)
                      instanceof Decoded<ServerMessage>(ServerMessage.Command command)) {
                    say(socket, LinkCodec.encode(new AgentMessage.Ack(command.seq())));
                  }
                }
              } catch (IOException e) {
                // the test is over
              }
            });
  }

  /** Whole lines, also of several threads. */
  private static void say(Socket socket, byte[] lines) throws IOException {
    synchronized (socket) {
      socket.getOutputStream().write(lines);
    }
  }

  private static State standing(double battery) {
    return new State(
        0,
        true,
        new Pose(0.5, 0.5, 0),
        new Speed(0, 0),
        Mode.IDLE,
        null,
        0,
        Role.ALONE,
        0,
        0,
        0,
        battery,
        List.of(),
        List.of(),
        null,
        null,
        List.of());
  }
}
