package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.DaemonThread;
import org.toqa.allocation.Policy;
import org.toqa.fleet.history.EventArchive.Entry;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Pose;
import org.toqa.grid.FloorReader;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;
import org.toqa.store.Database;
import org.toqa.store.JdbiEventArchive;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.wording.Sentence;

/** The fleet over a real store, and a robot's daemon that is paired, both in real time. */
@Tag("full")
@Timeout(120)
class PairedFleetTest {

  private static final Duration LIMIT = Duration.ofSeconds(40);

  @TempDir private Path folder;
  private final Database database = MemoryDatabase.open("paired-" + System.nanoTime());
  private final InstantSource clock = InstantSource.system();
  private @Nullable AgentFleet fleet;
  private @Nullable DaemonThread daemon;

  @BeforeEach
  void start() throws Exception {
    Files.writeString(
        folder.resolve("agent.yaml"),
        """
        name: r1
        port: 0
        dataDir: robot
        chassis: {type: simulated, start: {x: 1.05, y: 1.05, heading: 0}}
        """);
    daemon = daemon(true);
    fleet = fleet();
  }

  @AfterEach
  void close() throws Exception {
    fleetNow().close();
    daemonNow().close();
    database.close();
  }

  private AgentFleet fleetNow() {
    return Objects.requireNonNull(fleet);
  }

  private DaemonThread daemonNow() {
    return Objects.requireNonNull(daemon);
  }

  private DaemonThread daemon(boolean pair) throws Exception {
    return DaemonThread.start(folder.resolve("agent.yaml"), pair);
  }

  private AgentFleet fleet() throws IOException {
    Path data = Files.createDirectories(folder.resolve("server"));
    return new AgentFleet(
        FloorsInMemory.of(FloorReader.read(Path.of("maps/lab.yaml"))),
        new JdbiFleetStore(database.jdbi()),
        new JdbiScheduleStore(database.jdbi()),
        new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(data)), false),
        Policy.OPTIMAL.method(),
        new FleetRules(Duration.ofSeconds(30), ChargingRules.USUAL, 1),
        clock,
        clock.instant());
  }

  private static <T> T answer(CompletionStage<T> answer) throws Exception {
    return answer.toCompletableFuture().get(20, TimeUnit.SECONDS);
  }

  private Answer<RobotView> add(String code) throws Exception {
    RobotOrder order =
        new RobotOrder(
            "r1", "127.0.0.1", daemonNow().port(), 5, null, PairingCode.parse(code).orElseThrow());
    return answer(fleetNow().addRobot(order, "boss"));
  }

  private Answer<RobotView> pairAnew(String code) throws Exception {
    PairingOrder order =
        new PairingOrder("127.0.0.1", daemonNow().port(), PairingCode.parse(code).orElseThrow());
    return answer(fleetNow().pairRobot("r1", order, "boss"));
  }

  /** Ticks until r1 is as wanted. */
  private RobotView until(Predicate<RobotView> condition) throws InterruptedException {
    long end = System.nanoTime() + LIMIT.toNanos();
    FleetSnapshot view = fleetNow().snapshots().latest();
    while (System.nanoTime() < end) {
      for (RobotView robot : view.robots()) {
        if (condition.test(robot)) {
          return robot;
        }
      }
      fleetNow().tick(clock.instant());
      view = fleetNow().snapshots().awaitNewer(view.version(), Duration.ofMillis(100));
    }
    return fail("It is still so: " + view);
  }

  /** Waits for a line of that kind in the history. */
  private EventRecord history(String kind) throws InterruptedException {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (System.nanoTime() < end) {
      fleetNow().tick(clock.instant());
      for (EventRecord event : events()) {
        if (event.kind().equals(kind)) {
          return event;
        }
      }
      fleetNow()
          .snapshots()
          .awaitNewer(fleetNow().snapshots().latest().version(), Duration.ofMillis(100));
    }
    return fail("There is no " + kind + " in " + events());
  }

  private List<EventRecord> events() {
    return new JdbiEventArchive(database.jdbi())
        .events(new Filter(null, "r1", null, null, null, null, true), Long.MAX_VALUE, 100).stream()
            .map(Entry::event)
            .toList();
  }

  private static boolean isHeard(RobotView robot) {
    return robot.state() == RobotState.IDLE;
  }

  @Test
  void robotIsPairedByItsCodeAndKnownAfterRestartsOfBoth() throws Exception {
    Answer<RobotView> added = add(daemonNow().pairingCode());

    assertInstanceOf(Answer.Accepted.class, added, added.toString());
    assertNotNull(until(PairedFleetTest::isHeard).record().fingerprint());

    daemonNow().close();
    fleetNow().close();
    int port = daemonNow().port();
    Files.writeString(
        folder.resolve("agent.yaml"),
        Files.readString(folder.resolve("agent.yaml")).replace("port: 0", "port: " + port));
    daemon = daemon(false);
    fleet = fleet();
    until(PairedFleetTest::isHeard);
  }

  @Test
  void wrongCodeIsRefusedAddsNobodyAndIsInTheHistory() throws Exception {
    String code = daemonNow().pairingCode();
    char last = code.charAt(code.length() - 1);
    String wrong = code.substring(0, code.length() - 1) + (last == 'A' ? 'B' : 'A');

    assertEquals(
        new Answer.Rejected<>("code", Sentence.verbatim("The code is wrong; tries left: 4.")),
        add(wrong));
    assertEquals(
        "boss could not pair r1: The code is wrong; tries left: 4.",
        history("robot.pairing-refused").text());
    assertTrue(new JdbiFleetStore(database.jdbi()).robots().isEmpty());
    assertInstanceOf(Answer.Accepted.class, add(code));
  }

  @Test
  void replacedKeyIsAnAlertUntilTheRobotIsPairedAnew() throws Exception {
    add(daemonNow().pairingCode());
    RobotView before = until(PairedFleetTest::isHeard);
    daemonNow().close();
    Files.delete(folder.resolve("robot").resolve("link.p12"));
    Files.writeString(
        folder.resolve("agent.yaml"),
        Files.readString(folder.resolve("agent.yaml"))
            .replace("port: 0", "port: " + daemonNow().port()));
    daemon = daemon(true);

    String alert = String.valueOf(until(robot -> robot.alert() != null).alert());
    assertTrue(
        Objects.requireNonNull(alert).contains("its key differs from the recorded one"), alert);
    assertEquals(alert, history("robot.link-refused").text());

    assertInstanceOf(Answer.Accepted.class, pairAnew(daemonNow().pairingCode()));
    RobotView after = until(robot -> isHeard(robot) && robot.alert() == null);
    assertNotEquals(before.record().fingerprint(), after.record().fingerprint());
    assertEquals("boss paired r1 with this server", history("robot.paired").text());
  }

  @Test
  void unknownPeerOfTheRobotIsInTheHistory() throws Exception {
    add(daemonNow().pairingCode());
    until(PairedFleetTest::isHeard);
    try (var unpaired = new Socket(InetAddress.getLoopbackAddress(), daemonNow().port())) {
      Drive drive = new Drive(1, null, 0, new Pose(1.05, 1.05, 0), List.of(), 0, true, 0);
      unpaired.getOutputStream().write(LinkCodec.encode(drive)); // without encryption
      assertEquals(
          "r1 refused a connection. 127.0.0.1 was refused: it does not encrypt.",
          history("robot.stranger").text());
    }
    assertTrue(
        until(r -> !r.telemetry().errors().isEmpty())
            .telemetry()
            .errors()
            .getFirst()
            .text()
            .contains("127.0.0.1"));
  }
}
