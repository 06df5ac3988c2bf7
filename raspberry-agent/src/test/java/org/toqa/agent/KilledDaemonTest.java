package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.motion.Segment;

/** The daemon as a process of its own, in real time, killed without a warning. */
@Timeout(60)
class KilledDaemonTest {

  private static final Pose START = new Pose(1, 1, 0);

  @TempDir Path folder;
  private DaemonProcess daemon;

  @BeforeEach
  void start() throws IOException {
    Files.writeString(
        folder.resolve("agent.yaml"),
        """
        name: r1
        port: 0
        dataDir: data
        chassis: {type: simulated, start: {x: 1, y: 1}}
        """);
    daemon = DaemonProcess.launch(folder.resolve("agent.yaml"));
  }

  @AfterEach
  void end() {
    daemon.close();
  }

  @Test
  void killedInTheMiddleOfADriveItKnowsItsTaskAndItsPlace() throws Exception {
    Pose last;
    try (DaemonProcess.Peer peer = daemon.connect()) {
      assertEquals(START, peer.await(Hello.class, h -> true).pose());
      peer.say(new Drive(4, 5L, 2, START, List.of(new Segment(0.5, 0, 60)), 1, true, 0));
      peer.await(Ack.class, ack -> ack.seq() == 4);
      last = peer.await(State.class, s -> s.pose().x() > 1.2).pose();
    }
    daemon.kill();
    daemon = DaemonProcess.launch(folder.resolve("agent.yaml"));

    try (DaemonProcess.Peer peer = daemon.connect()) {
      Hello hello = peer.await(Hello.class, h -> true);
      assertEquals(5L, hello.task());
      assertEquals(2, hello.phase());
      assertEquals(4, hello.lastSeq());
      assertEquals(0, hello.drive());
      assertTrue(hello.localised());
      assertTrue(hello.pose().x() >= last.x(), "the body did not jump back");
    }
  }

  @Test
  void terminatedItEndsCleanly() throws Exception {
    try (DaemonProcess.Peer peer = daemon.connect()) {
      peer.await(Hello.class, h -> true);
      daemon.terminate();

      assertEquals(128 + 15, daemon.exitCode()); // ended by SIGTERM, after its shutdown hooks
      assertTrue(daemon.output().lines().toList().getLast().endsWith("r1: ended."));
    }
  }
}
