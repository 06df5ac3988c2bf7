package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.TcpRobotLinks;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.motion.Segment;

@Timeout(60)
class SimulatedFleetTest {

  private static final Pose START = new Pose(1, 1, 0);
  private static final List<SimulatedRobot> ROBOTS =
      List.of(
          new SimulatedRobot("r1", START, 5, 1),
          new SimulatedRobot("r2", new Pose(2, 1, 0), 5, 1),
          new SimulatedRobot("r3", new Pose(3, 1, 0), 8, 1));

  @TempDir Path folder;

  @Test
  void everyRobotAnswersAtAPortOfItsOwn() throws Exception {
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 10);
        SimulatedFleet fleet = SimulatedFleet.open(folder, ROBOTS, List.of(), clock)) {
      clock.start();

      for (SimulatedRobot robot : ROBOTS) {
        try (Peer peer = new Peer(robot.name(), fleet, folder)) {
          Hello hello = peer.await(Hello.class);
          assertEquals(robot.start(), hello.pose());
          assertEquals(robot.maxLoad(), hello.maxLoad());
        }
      }
    }
  }

  @Test
  void robotsAreFoundAgainWhereTheyStood() throws Exception {
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 50);
        SimulatedFleet fleet = SimulatedFleet.open(folder, ROBOTS, List.of(), clock);
        Peer peer = new Peer("r1", fleet, folder)) {
      clock.add(nanos -> peer.ping(), Duration.ofMillis(500));
      clock.start();
      peer.await(Hello.class);
      peer.link.send(
          new Drive(1, 5L, 1, START, List.of(new Segment(0.25, 0, 40)), 1, true, 0)); // 10 m
      assertEquals(new Done(5L, 1, 1), peer.await(Done.class));
    }

    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 1);
        SimulatedFleet fleet = SimulatedFleet.open(folder, ROBOTS, List.of(), clock);
        Peer peer = new Peer("r1", fleet, folder)) {
      clock.start();
      Hello hello = peer.await(Hello.class);
      assertEquals(11, hello.pose().x(), 0.003);
      assertEquals(1, hello.pose().y(), 0.003);
      assertTrue(hello.localised());
    }
  }

  /** At this speed two seconds of silence are four real milliseconds. */
  @Test
  void worldThatRunsTooFastForTheMachineTripsNoTimer() throws Exception {
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 500);
        SimulatedFleet fleet = SimulatedFleet.open(folder, ROBOTS, List.of(), clock);
        Peer peer = new Peer("r1", fleet, folder)) {
      clock.start();
      peer.await(Hello.class);
      clock.add(nanos -> peer.ping(), Duration.ofMillis(500));
      // the second segment is never released: a silence would show as HOLDING
      peer.link.send(
          new Drive(
              1,
              5L,
              1,
              START,
              List.of(new Segment(0.25, 0, 1), new Segment(0.25, 0, 1)),
              1,
              true,
              0));
      for (int i = 0; i < 1_000; i++) {
        State state = peer.await(State.class);
        assertTrue(state.mode() != Mode.HOLDING, "held at " + clock.instant());
      }
    }
  }

  /** A server in the test's process. */
  private static final class Peer implements RobotLink.Listener, AutoCloseable {
    private final BlockingQueue<AgentMessage> heard = new LinkedBlockingQueue<>();
    private final AtomicLong seq = new AtomicLong(1_000);
    private final RobotLink link;

    Peer(String robot, SimulatedFleet fleet, Path keys) throws IOException {
      link =
          new TcpRobotLinks(new LinkTls(IdentityFile.open(keys)), false)
              .open(new RobotAddress(robot, "localhost", fleet.port(robot), null), this);
    }

    void ping() {
      link.send(new Ping(seq.incrementAndGet()));
    }

    <M extends AgentMessage> M await(Class<M> type) throws InterruptedException {
      AgentMessage message = heard.poll(20, TimeUnit.SECONDS);
      while (message != null && !type.isInstance(message)) {
        message = heard.poll(20, TimeUnit.SECONDS);
      }
      return assertInstanceOf(type, message);
    }

    @Override
    public void connected(Hello hello) {
      heard.add(hello);
    }

    @Override
    public void received(AgentMessage message) {
      heard.add(message);
    }

    @Override
    public void refused(String sentence) {
      disconnected(sentence);
    }

    @Override
    public void disconnected(String sentence) {}

    @Override
    public void close() {
      link.close();
    }
  }
}
