package org.toqa.agent.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.ConnectException;
import java.net.NoRouteToHostException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.FormationServer;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.trust.LinkSocket;
import org.toqa.motion.Segment;
import org.toqa.testbed.Needed;
import org.toqa.testbed.RobotNetwork;
import org.toqa.testbed.ToqaProcess;

/** Packaged daemons, each in a network of its own whose cable is pulled, in real time. */
@Tag("full")
@Timeout(value = 150, threadMode = ThreadMode.SEPARATE_THREAD)
class LostNetworkIT {

  private static final int PORT = 7275;
  private static final long TASK = 5;
  private static final double SPEED = 0.25;

  /** 2 m each. */
  private static final List<Segment> SEGMENTS =
      List.of(new Segment(SPEED, 0, 8), new Segment(SPEED, 0, 8));

  /** Within which time a group stands by contract; judged by how far each still gets. */
  private static final double STAND_SECONDS = 0.8;

  /** Where the robots are at first; y is 1. */
  private static final int[] X = {1, 3, 1};

  /** Within which time it has come to the end of what is released, also on a busy machine. */
  private static final int SURELY_THERE_SECONDS = 60;

  private static final long CONNECT_NANOS = 20_000_000_000L;
  private static final long BETWEEN_TRIES_NANOS = 250_000_000;

  @TempDir Path folder;
  private RobotNetwork network;
  private final List<ToqaProcess> daemons = new ArrayList<>();
  private final List<FormationServer> servers = new ArrayList<>();

  @BeforeEach
  void start() throws Exception {
    Needed.orLeftOut(
        RobotNetwork.isAllowed(),
        "network namespaces, whose cables are pulled: run it as root, with ip (Debian: iproute2)");
    network = new RobotNetwork(3);
    for (int robot = 0; robot < 3; robot++) {
      daemons.add(daemon(robot));
    }
    for (int robot = 0; robot < 3; robot++) {
      daemons.get(robot).awaitErr("listening on");
    }
  }

  @AfterEach
  void end() throws IOException {
    servers.forEach(FormationServer::close);
    daemons.forEach(ToqaProcess::close);
    if (network != null) {
      network.close();
    }
  }

  /** Side by side, so that a minute is waited for only once. */
  @Test
  void robotFinishesWhatIsReleasedAndHoldsWhileItsNetworkIsGone() throws Exception {
    FormationServer ofMinute = driving(2);
    ofMinute.awaitState(s -> s.pose().x() > X[2] + 1);
    network.cut(2);
    long cut = System.nanoTime();

    forOneSecondNothingIsNoticed();
    FormationServer ofFiveSeconds = driving(1);
    ofFiveSeconds.awaitState(s -> s.pose().x() > X[1] + 1.2);
    network.cut(1);
    holdsAfter(1, ofFiveSeconds, System.nanoTime(), 5);
    holdsAfter(2, ofMinute, cut, 60);
  }

  private void forOneSecondNothingIsNoticed() throws Exception {
    FormationServer server = driving(0);
    double x = server.awaitState(s -> s.pose().x() > 1.3).pose().x();
    network.cut(0);
    waitUntil(System.nanoTime(), 1);
    network.mend(0);

    State after = server.awaitState(s -> s.pose().x() > x + 2 * SPEED);
    assertEquals(Mode.DRIVING, after.mode());
    State atEnd = server.awaitState(s -> s.segment() == 1);
    assertEquals(3, atEnd.pose().x(), 0.02);
    assertTrue(
        server.states().stream().allMatch(s -> s.mode() != Mode.HOLDING && s.errors().isEmpty()));
  }

  /**
   * The connection is new: the server has given the old one up after 5 s. Nothing that was sent on
   * that may arrive later, or the robot would have heard of its server before it is greeted.
   */
  private void holdsAfter(int robot, FormationServer old, long cut, int seconds) throws Exception {
    waitUntil(cut, seconds);
    old.close();
    network.mend(robot);
    FormationServer server = connect(robot);
    Hello hello = server.awaitHello();
    assertEquals(TASK, hello.task());
    if (seconds >= SURELY_THERE_SECONDS) {
      assertEquals(Mode.HOLDING, hello.mode());
    }
    State there = server.awaitState(s -> s.pose().x() > X[robot] + 1.9 && s.twist().v() < 0.001);
    assertEquals(1, there.segment());
    assertEquals(X[robot] + 2, there.pose().x(), 0.02); // the first segment
    server.assertAccepted(new Release(2, 1, 2));
    server.awaitState(
        s -> s.mode() == Mode.DRIVING && s.pose().x() > X[robot] + 2.2); // nobody said resume
  }

  @Test
  void groupStandsWhileItsLeaderIsGoneAndGoesOnWithIt() throws Exception {
    FormationServer ofLeader = connect(1); // at (3, 1)
    FormationServer ofFollower = connect(0); // at (1, 1)
    ofFollower.assertAccepted(new Follow(1, TASK, "r2", null, new Vec2(-2, 0), 0.05, null));
    ofLeader.assertAccepted(
        new Lead(1, TASK, 0.05, List.of(new Follower("r1", network.address(0), PORT, null)), null));
    List<Segment> segments = List.of(new Segment(SPEED, 0, 60));
    ofLeader.assertAccepted(new Drive(2, TASK, 2, new Pose(3, 1, 0), segments, 1, true, 0));
    ofFollower.awaitState(s -> s.mode() == Mode.FOLLOWING && s.pose().x() > 1.3);
    ofLeader.awaitState(s -> s.pose().x() > 3.3);

    network.cut(1);
    long cut = System.nanoTime();
    long cutMillis = System.currentTimeMillis();

    State lost = ofFollower.awaitState(s -> s.mode() == Mode.HOLDING);
    assertEquals("LEADER_LOST", lost.errors().getFirst().code());
    State stands = ofFollower.awaitState(s -> s.twist().v() < 0.001);
    State before = last(ofFollower, cutMillis);
    double driven = before.pose().distanceTo(stands.pose());
    assertTrue(
        driven < (secondsFrom(before, cutMillis) + STAND_SECONDS) * SPEED,
        "the follower still drove " + driven + " m");
    waitUntil(cut, 4);
    network.mend(1);
    State leader = last(ofLeader, cutMillis);
    double stopped = connect(1).awaitHello().pose().x(); // 4 s at 0.25 m/s would be 1 m
    assertTrue(
        stopped - leader.pose().x() < (secondsFrom(leader, cutMillis) + STAND_SECONDS) * SPEED,
        "the leader went on to " + stopped);
    ofFollower.awaitState(
        s ->
            s.mode() == Mode.FOLLOWING && s.errors().isEmpty() && s.pose().x() > stopped - 2 + 0.2);
  }

  /** The last that it told before then. */
  private static State last(FormationServer robot, long millis) {
    return robot.states().stream().filter(s -> s.stamp() <= millis).toList().getLast();
  }

  private static double secondsFrom(State told, long millis) {
    return (millis - told.stamp()) / 1000.0;
  }

  private ToqaProcess daemon(int robot) throws IOException {
    Path config =
        Files.writeString(
            folder.resolve("r%d.yaml".formatted(robot + 1)),
            """
            name: r%d
            address: %s
            plainTcpOffLoopback: true
            dataDir: r%1$d
            chassis: {type: simulated, noise: 0, start: {x: %d, y: 1}}
            """
                .formatted(robot + 1, network.address(robot), X[robot]));
    return ToqaProcess.command(
        folder,
        network.as(
            robot,
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx64m",
                "-jar",
                Path.of("target/toqa-agent.jar").toAbsolutePath().toString(),
                "--config",
                config.toString())));
  }

  private FormationServer driving(int robot) throws IOException {
    FormationServer server = connect(robot);
    Pose start = server.awaitHello().pose();
    server.assertAccepted(new Drive(1, TASK, 1, start, SEGMENTS, 1, true, 0));
    return server;
  }

  /** As a server does: a cable that was just mended has no route yet, so it tries again. */
  private FormationServer connect(int robot) throws IOException {
    long end = System.nanoTime() + CONNECT_NANOS;
    while (true) {
      try {
        Socket socket = new Socket(network.address(robot), PORT);
        socket.setSoLinger(true, 0); // what it could not send yet is dropped when it is closed
        FormationServer server = new FormationServer(LinkSocket.plain(socket));
        servers.add(server);
        return server;
      } catch (ConnectException | NoRouteToHostException e) {
        if (System.nanoTime() > end) {
          throw e;
        }
        LockSupport.parkNanos(BETWEEN_TRIES_NANOS);
      }
    }
  }

  private static void waitUntil(long begin, int seconds) {
    long end = begin + seconds * 1_000_000_000L;
    while (System.nanoTime() < end) {
      LockSupport.parkNanos(end - System.nanoTime());
    }
  }
}
