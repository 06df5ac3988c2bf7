package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBodyFile;
import org.toqa.geometry.Pose;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.motion.Segment;
import org.toqa.testbed.LinkRecorder;

@Timeout(60)
class SimulatedFleetTest {

  private static final Pose START = new Pose(1, 1, 0);
  private static final List<SimulatedRobot> ROBOTS =
      List.of(
          new SimulatedRobot("r1", START, 5, 1),
          new SimulatedRobot("r2", new Pose(1, 2, 0), 5, 1),
          new SimulatedRobot("r3", new Pose(1, 3, 0), 8, 1));

  @TempDir Path folder;

  @Test
  void everyRobotAnswersAtAPortOfItsOwn() throws Exception {
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 10);
        SimulatedFleet fleet =
            SimulatedFleet.open(folder, ROBOTS, SimulatedFloor.boundless(), clock)) {
      clock.start();

      for (SimulatedRobot robot : ROBOTS) {
        try (Peer peer = new Peer(robot.name(), fleet, folder)) {
          Hello hello = peer.heard.await(Hello.class);
          assertEquals(robot.start(), hello.pose());
          assertEquals(robot.maxLoad(), hello.maxLoad());
        }
      }
    }
  }

  @Test
  void robotsAreFoundAgainWhereTheyWere() throws Exception {
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 50);
        SimulatedFleet fleet =
            SimulatedFleet.open(folder, ROBOTS, SimulatedFloor.boundless(), clock);
        Peer peer = new Peer("r1", fleet, folder)) {
      clock.add(nanos -> peer.ping(), Duration.ofMillis(500));
      clock.start();
      peer.heard.await(Hello.class);
      peer.link.send(
          new Drive(1, 5L, 1, START, List.of(new Segment(0.25, 0, 40)), 1, true, 0)); // 10 m
      assertEquals(new Done(5L, 1, 1), peer.heard.await(Done.class));
    }

    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 1);
        SimulatedFleet fleet =
            SimulatedFleet.open(folder, ROBOTS, SimulatedFloor.boundless(), clock);
        Peer peer = new Peer("r1", fleet, folder)) {
      clock.start();
      Hello hello = peer.heard.await(Hello.class);
      assertEquals(11, hello.pose().x(), 0.003);
      assertEquals(1, hello.pose().y(), 0.003);
      assertTrue(hello.localised());
    }
  }

  @Test
  void robotAtRestIsTickedAsOftenAsARealOne() throws Exception {
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 1);
        SimulatedFleet fleet =
            SimulatedFleet.open(folder, ROBOTS, SimulatedFloor.boundless(), clock);
        SimulatedBodyFile body = new SimulatedBodyFile(folder.resolve("r1"))) {
      clock.advance(Duration.ofSeconds(2));
      long exchanges = body.count();
      clock.advance(Duration.ofSeconds(10));
      assertEquals(150, body.count() - exchanges); // every 66.7 ms
      assertEquals(START, fleet.truePose("r1").orElseThrow());
    }
  }

  /** At this speed two seconds of silence are four real milliseconds. */
  @Test
  void worldThatRunsTooFastForTheMachineTripsNoTimer() throws Exception {
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 500);
        SimulatedFleet fleet =
            SimulatedFleet.open(folder, ROBOTS, SimulatedFloor.boundless(), clock);
        Peer peer = new Peer("r1", fleet, folder)) {
      clock.start();
      peer.heard.await(Hello.class);
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
        State state = peer.heard.await(State.class);
        assertTrue(state.mode() != Mode.HOLDING, "held at " + clock.instant());
      }
    }
  }

  /** A server in the test's process. */
  private static final class Peer implements AutoCloseable {
    private final LinkRecorder heard = new LinkRecorder();
    private final AtomicLong seq = new AtomicLong(1_000);
    private final RobotLink link;

    Peer(String robot, SimulatedFleet fleet, Path keys) throws IOException {
      link =
          new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(keys)), false)
              .open(new RobotAddress(robot, "localhost", fleet.port(robot), null), heard);
    }

    void ping() {
      link.send(new Ping(seq.incrementAndGet()));
    }

    @Override
    public void close() {
      link.close();
    }
  }
}
