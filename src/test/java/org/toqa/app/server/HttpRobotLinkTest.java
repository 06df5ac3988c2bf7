package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.app.robot.SimulatedHttpRobot;
import org.toqa.app.robot.SimulatedHttpRobot.Fault;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.http.RobotDescription.Sonar;
import org.toqa.link.http.RobotToken;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.localisation.GridWalls;
import org.toqa.localisation.Walls;
import org.toqa.motion.Segment;
import org.toqa.testbed.FaultyTcpProxy;
import org.toqa.testbed.LinkRecorder;

/** A robot that takes wheel commands over HTTP, as the fleet sees it through its link. */
@Tag("full")
class HttpRobotLinkTest {
  private static final RobotToken TOKEN = new RobotToken("a-token-of-a-test");
  private static final Pose START = new Pose(3, 4, 0);

  @TempDir private Path folder;
  private final LinkRecorder heard = new LinkRecorder();
  private final AtomicLong seq = new AtomicLong();
  private final ScheduledExecutorService pings = Executors.newScheduledThreadPool(1);
  private final PublishedRanges ranges = new PublishedRanges(System::nanoTime);

  /** A room, as its map has it, and as it is. */
  private Walls map = new GridWalls(new OccupancyGrid(60, 80, 0.1, Vec2.ZERO, new BitSet()));

  private Walls walls = map;
  private boolean isSomebodyBehind = true;
  private HttpRobotLinks links;
  private SimulatedHttpRobot robot;
  private @Nullable RobotLink link;

  @BeforeEach
  void start() throws IOException {
    LinkTls tls = new LinkTls(IdentityFile.open(folder));
    RobotLinkFactory tcp = new TcpRobotLinkFactory(tls, false);
    links =
        new HttpRobotLinks(
            tcp,
            tcp,
            folder.resolve("robots"),
            tls.fingerprint(),
            false,
            ranges,
            InstantSource.system());
    robot = new SimulatedHttpRobot(settings(0, null));
  }

  private SimulatedHttpRobot.Settings settings(int port, @Nullable Path body) {
    SimulatedHttpRobot.Settings usual = SimulatedHttpRobot.Settings.of(TOKEN, START);
    return new SimulatedHttpRobot.Settings(
        usual.address(),
        port,
        TOKEN,
        null,
        body,
        START,
        0.005,
        0,
        1,
        5,
        Duration.ZERO,
        List.of(),
        null);
  }

  @AfterEach
  void close() throws InterruptedException {
    pings.shutdownNow();
    if (link != null) {
      link.close();
    }
    robot.close();
    awaitNoDaemon();
  }

  /** Else the folder could not be removed. */
  static void awaitNoDaemon() throws InterruptedException {
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (thread.getName().equals("http-h1")) {
        thread.join(20_000);
      }
    }
  }

  private RobotLink connect() {
    return connect(TOKEN, null);
  }

  private RobotLink connect(RobotToken token, @Nullable Fingerprint fingerprint) {
    return connect(robot.port(), token, fingerprint);
  }

  private RobotLink connect(int port, RobotToken token, @Nullable Fingerprint fingerprint) {
    RobotLink opened =
        links.open(new RobotAddress("h1", "127.0.0.1", port, fingerprint, null, token), heard);
    link = opened;
    var _ =
        pings.scheduleAtFixedRate(
            () -> opened.send(new Ping(seq.incrementAndGet())), 200, 500, TimeUnit.MILLISECONDS);
    return opened;
  }

  private void locateAndDrive(RobotLink opened, List<Segment> segments) throws Exception {
    opened.send(new Locate(seq.incrementAndGet(), START));
    heard.await(State.class, State::localised);
    opened.send(new Drive(seq.incrementAndGet(), 5L, 1, START, segments, segments.size(), true, 0));
  }

  @Test
  void itDrivesAPathToItsEnd() throws Exception {
    RobotLink opened = connect();

    Hello hello = heard.await(Hello.class);
    assertEquals("h1", hello.robot());
    assertEquals("differential", hello.kind());
    assertEquals(5, hello.maxLoad());
    assertFalse(hello.localised());
    // a metre in the direction that it looks, a quarter turn to the left, and half a metre
    locateAndDrive(
        opened,
        List.of(new Segment(0.25, 0, 4), new Segment(0, Math.PI / 4, 2), new Segment(0.25, 0, 2)));
    heard.await(Done.class);
    State end = heard.await(State.class, state -> state.mode() == Mode.IDLE);

    assertEquals(4, end.pose().x(), 0.02);
    assertEquals(4.5, end.pose().y(), 0.02);
    assertEquals(4, robot.truePose().x(), 0.05);
    assertEquals(4.5, robot.truePose().y(), 0.05);
  }

  /**
   * In a room of 6 m x 8 m; behind it somebody stands. Its wheels are so unlike that by their
   * counts alone it ends beside its path by more than a hand.
   */
  @Test
  void rangesThatItPublishesCorrectWhereItTakesItselfToBe() throws Exception {
    RobotLink opened = connectWithSonar();
    opened.send(
        new Locate(
            seq.incrementAndGet(), new Pose(START.x() + 0.05, START.y() - 0.04, START.theta())));
    State corrected =
        heard.await(
            State.class, state -> state.localised() && state.pose().distanceTo(START) < 0.01);
    List<Segment> metre = List.of(new Segment(0.25, 0, 4));
    opened.send(new Drive(seq.incrementAndGet(), 5L, 1, corrected.pose(), metre, 1, true, 0));
    heard.await(Done.class);
    State end = heard.await(State.class, state -> state.mode() == Mode.IDLE);

    assertEquals(0, end.pose().distanceTo(robot.truePose()), 0.03, end.pose()::toString);
    assertEquals(0, robot.truePose().distanceTo(new Pose(4, 4, 0)), 0.05);
  }

  /** The same room, in which it was said to stand a metre from where it does. */
  @Test
  void whoseRangesDoNotFitTheMapStandsAndDoesNotKnowWhereItIs() throws Exception {
    RobotLink opened = connectWithSonar();
    Pose said = new Pose(START.x() - 0.7, START.y() + 0.7, START.theta());
    opened.send(new Locate(seq.incrementAndGet(), said));
    heard.await(State.class, State::localised);
    List<Segment> metre = List.of(new Segment(0.25, 0, 4));
    opened.send(new Drive(seq.incrementAndGet(), 5L, 1, said, metre, 1, true, 0));

    State lost = heard.await(State.class, HttpRobotLinkTest::isLost);
    assertEquals(Mode.ERROR, lost.mode());
    assertFalse(lost.localised());
  }

  /**
   * It takes itself to be before the walls of its room, and is in a hall that has none in sight.
   */
  @Test
  void whoSeesNothingWhereWallsShouldBeIsLost() throws Exception {
    walls = new GridWalls(new OccupancyGrid(600, 600, 0.1, new Vec2(-30, -30), new BitSet()));
    RobotLink opened = connectWithSonar();
    locateAndDrive(opened, List.of(new Segment(0.25, 0, 4)));

    assertFalse(heard.await(State.class, HttpRobotLinkTest::isLost).localised());
  }

  /** Nothing is in sight, and nothing should be: it drives by its counts, however far. */
  @Test
  void inAWideHallNobodyIsLostWhoSeesNothing() throws Exception {
    map = new GridWalls(new OccupancyGrid(600, 600, 0.1, new Vec2(-30, -30), new BitSet()));
    walls = map;
    isSomebodyBehind = false;
    RobotLink opened = connectWithSonar();
    locateAndDrive(opened, List.of(new Segment(0.25, 0, 4)));

    heard.await(Done.class);

    State end = heard.await(State.class, state -> state.mode() == Mode.IDLE);
    assertTrue(end.localised());
    assertEquals(4, end.pose().x(), 0.02);
  }

  private static boolean isLost(State state) {
    return state.errors().stream().anyMatch(error -> error.code().equals("PLACE_LOST"));
  }

  private RobotLink connectWithSonar() throws Exception {
    robot.close();
    SimulatedHttpRobot.Settings usual = SimulatedHttpRobot.Settings.of(TOKEN, START);
    Sonar sonar = new Sonar(5, 0.01);
    robot =
        new SimulatedHttpRobot(
            new SimulatedHttpRobot.Settings(
                usual.address(),
                0,
                TOKEN,
                null,
                null,
                START,
                0,
                0.03,
                2,
                5,
                Duration.ZERO,
                List.of(),
                sonar));
    RobotLink opened = connect();
    heard.await(Hello.class);
    var _ = pings.scheduleAtFixedRate(this::publish, 0, 50, TimeUnit.MILLISECONDS);
    return opened;
  }

  /** What four sensors on its rim see of the walls, ahead, to both sides and back. */
  private void publish() {
    Pose truth = robot.truePose();
    List<Double> angles = List.of(0.0, Math.PI / 2, Math.PI, -Math.PI / 2);
    List<Double> metres = new ArrayList<>();
    for (double angle : angles) {
      Pose rim = new Pose(0.1275 * Math.cos(angle), 0.1275 * Math.sin(angle), angle);
      metres.add(
          angle == Math.PI && isSomebodyBehind
              ? 0.6
              : walls.hit(truth.compose(rim), 20).map(Walls.Hit::distance).orElse(20.0));
    }
    ranges.put("h1", metres, angles, () -> Optional.of(map));
  }

  @Test
  void answersThatAreLateDoNotMatter() throws Exception {
    robot.setDelay(Duration.ofMillis(40));
    RobotLink opened = connect();
    heard.await(Hello.class);
    locateAndDrive(opened, List.of(new Segment(0.25, 0, 4)));

    heard.await(Done.class);

    assertEquals(4, robot.truePose().x(), 0.05);
  }

  @Test
  void wrongTokenIsToldWithItsReason() throws Exception {
    connect(new RobotToken("another-token-of-it"), null);

    String sentence = heard.await(LinkRecorder.Refusal.class).sentence();

    assertTrue(sentence.contains("does not accept this server’s token"), sentence);
    assertFalse(sentence.contains("another-token-of-it"));
  }

  @Test
  void nobodyAtThatAddressIsTold() throws Exception {
    int port = robot.port();
    robot.close();
    robot = new SimulatedHttpRobot(settings(0, null));
    connect(port, TOKEN, null);

    String sentence = heard.await(LinkRecorder.End.class).sentence();

    assertTrue(sentence.contains("127.0.0.1:" + port), sentence);
  }

  /** The robot stands by its own silence rule, and the reason is told; then it goes on. */
  @ParameterizedTest
  @EnumSource(names = {"SILENT", "NONSENSE", "TOO_LONG", "WRONG_RANGES", "BROKEN"})
  void robotWhoseAnswersAreNoneStandsAndIsLostWithTheReason(Fault fault) throws Exception {
    RobotLink opened = connect();
    heard.await(Hello.class);
    locateAndDrive(opened, List.of(new Segment(0.25, 0, 40)));
    heard.await(State.class, state -> state.pose().x() > START.x() + 0.1);

    robot.setFault(fault);
    State wrong = heard.await(State.class, state -> state.mode() == Mode.ERROR);
    String sentence = heard.await(LinkRecorder.End.class).sentence();

    assertTrue(wrong.errors().getFirst().code().startsWith("CHASSIS_"), wrong.toString());
    assertTrue(
        sentence.contains(
            switch (fault) {
              case NONSENSE -> "it is not JSON";
              case TOO_LONG -> "it is longer than 16384 bytes";
              case WRONG_RANGES -> "ranges must be up to 16 numbers";
              case BROKEN -> "the status 500";
              default -> "does not answer";
            }),
        sentence);
    double stopped = robot.truePose().x();
    robot.setFault(Fault.NONE);
    Hello again = heard.await(Hello.class);
    assertEquals(0, again.drive());
    assertEquals(5L, again.task());
    assertTrue(again.localised(), "its counts have gone on");
    assertEquals(stopped, robot.truePose().x(), 0.001); // it waits for a new drive
    assertEquals(robot.truePose().x(), again.pose().x(), 0.02);
  }

  /**
   * Judged by where the body truly is, on its own clock. Orders that the network held back come
   * when it is back, all at once.
   */
  @ParameterizedTest
  @ValueSource(ints = {1, 5, 60})
  @Timeout(60)
  void networkThatIsCutLetsTheRobotStandInTime(int seconds) throws Exception {
    robot.close();
    AtomicLong skipped = new AtomicLong();
    robot =
        new SimulatedHttpRobot(
            settings(0, null), Surroundings.EMPTY, () -> System.nanoTime() + skipped.get());
    try (FaultyTcpProxy cable = new FaultyTcpProxy(robot.port())) {
      RobotLink opened = connect(cable.port(), TOKEN, null);
      heard.await(Hello.class);
      locateAndDrive(opened, List.of(new Segment(0.25, 0, 40)));
      heard.await(State.class, state -> state.pose().x() > START.x() + 0.1);

      cable.silence();
      double atCut = robot.truePose().x();
      heard.await(State.class, state -> state.mode() == Mode.ERROR);
      boolean isLost = seconds > 1;
      if (isLost) {
        heard.await(LinkRecorder.End.class);
      }
      skipped.addAndGet(Duration.ofSeconds(seconds).toNanos());
      double stopped = robot.truePose().x();
      // an order is obeyed within 400 ms of the answer before it, for 200 ms; and it brakes
      assertTrue(stopped - atCut < 0.25 * 0.6 + 0.1, "it went on for " + (stopped - atCut));
      cable.mend();

      if (isLost) {
        Hello again = heard.await(Hello.class);
        assertEquals(0, again.drive());
        assertEquals(stopped, robot.truePose().x(), 0.001); // it waits for a new drive
        assertEquals(stopped, again.pose().x(), 0.02);
      } else {
        heard.await(State.class, state -> state.pose().x() > stopped + 0.1); // it goes on
      }
    }
  }

  /** Else it would be lost, and nobody knew why. */
  @Test
  @Timeout(60)
  void robotThatFallsSilentAgainIsToldAgain() throws Exception {
    robot.setFault(Fault.SILENT_AFTER_FIRST);
    connect();

    heard.await(Hello.class);
    String sentence = heard.await(LinkRecorder.End.class).sentence();
    heard.await(Hello.class);

    assertEquals(sentence, heard.await(LinkRecorder.End.class).sentence());
  }

  /** As whose emergency stop was pressed and turned back: it does not go on by itself. */
  @Test
  void robotThatWasStoppedByItselfWaitsForANewDrive() throws Exception {
    RobotLink opened = connect();
    heard.await(Hello.class);
    locateAndDrive(opened, List.of(new Segment(0.25, 0, 40)));
    heard.await(State.class, state -> state.pose().x() > START.x() + 0.1);

    robot.setFault(Fault.EMERGENCY);
    State stopped =
        heard.await(State.class, state -> state.mode() == Mode.ERROR && state.twist().v() == 0);
    robot.setFault(Fault.NONE);
    State free = heard.await(State.class, state -> state.errors().isEmpty());

    assertEquals(
        List.of("EMERGENCY"), stopped.errors().stream().map(AgentMessage.Fault::code).toList());
    assertEquals(Mode.IDLE, free.mode());
    assertEquals(0, free.drive());
    assertEquals(5L, free.task());
    List<Segment> half = List.of(new Segment(0.25, 0, 2));
    opened.send(new Drive(seq.incrementAndGet(), 5L, 1, free.pose(), half, 1, true, 0));
    heard.await(Done.class);
    assertEquals(free.pose().x() + 0.5, robot.truePose().x(), 0.05);
  }

  @Test
  void countsThatJumpAreNotBelieved() throws Exception {
    RobotLink opened = connect();
    heard.await(Hello.class);
    opened.send(new Locate(seq.incrementAndGet(), START));
    heard.await(State.class, State::localised);

    robot.setFault(Fault.JUMPED_COUNTS);

    State lied = heard.await(State.class, state -> state.mode() == Mode.ERROR);
    assertFalse(lied.localised());
    assertEquals("WHEEL_COUNTS", lied.errors().getFirst().code());
  }

  @Test
  void robotThatWasSwitchedOffDoesNotKnowWhereItIs() throws Exception {
    int port = robot.port();
    RobotLink opened = connect();
    heard.await(Hello.class);
    opened.send(new Locate(seq.incrementAndGet(), START));
    heard.await(State.class, State::localised);

    robot.close();
    heard.await(LinkRecorder.End.class);
    robot = new SimulatedHttpRobot(settings(port, null));

    assertFalse(heard.await(Hello.class).localised());
  }

  @Test
  void encryptedRobotIsKnownByItsFingerprint() throws Exception {
    var identity = IdentityFile.open(Files.createDirectory(folder.resolve("key")));
    SimulatedHttpRobot.Settings usual = settings(0, null);
    robot.close();
    robot =
        new SimulatedHttpRobot(
            new SimulatedHttpRobot.Settings(
                usual.address(),
                0,
                TOKEN,
                identity,
                null,
                START,
                0,
                0,
                1,
                5,
                Duration.ZERO,
                List.of(),
                null));
    RobotLink distrustful = connect(TOKEN, new Fingerprint("0".repeat(64)));
    String sentence = heard.await(LinkRecorder.Refusal.class).sentence();
    assertTrue(sentence.contains("another certificate"), sentence);
    distrustful.close();
    awaitNoDaemon();

    connect(TOKEN, identity.fingerprint());

    assertEquals("h1", heard.await(Hello.class).robot());
  }
}
