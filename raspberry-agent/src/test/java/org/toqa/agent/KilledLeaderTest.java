package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.motion.Segment;

/**
 * Two daemons as processes of their own, in real time; the leader is killed without a warning. That
 * the group stands in time is judged in simulated time, in {@link FormationTest}; here, by how far
 * the follower still gets.
 */
@Tag("full")
@Timeout(60)
class KilledLeaderTest {

  private static final long TASK = 5;
  private static final Pose START = new Pose(2, 1, 0);

  private static final double SPEED = 0.25;

  /** Within which time a group stands by contract. */
  private static final double STAND_SECONDS = 0.8;

  @TempDir Path folder;

  @Test
  void followerOfAKilledLeaderStandsAndSaysWhy() throws Exception {
    try (DaemonProcess leader = DaemonProcess.launch(configuration("r1", 2));
        DaemonProcess follower = DaemonProcess.launch(configuration("r2", 1));
        FormationServer ofLeader = FormationServer.plain(leader.port());
        FormationServer ofFollower = FormationServer.plain(follower.port())) {
      ofFollower.assertAccepted(new Follow(1, TASK, "r1", null, new Vec2(-1, 0), 0.05, null));
      ofLeader.assertAccepted(
          new Lead(
              1,
              TASK,
              0.05,
              List.of(new Follower("r2", "127.0.0.1", follower.port(), null)),
              null));
      List<Segment> segments = List.of(new Segment(SPEED, 0, 60));
      ofLeader.assertAccepted(new Drive(2, TASK, 2, START, segments, 1, true, 0));
      ofFollower.awaitState(s -> s.mode() == Mode.FOLLOWING && s.pose().x() > 1.2);

      leader.process().destroyForcibly();
      long gone = System.currentTimeMillis();

      State lost = ofFollower.awaitState(s -> s.mode() == Mode.HOLDING);
      assertEquals("LEADER_LOST", lost.errors().getFirst().code());
      State stopped = ofFollower.awaitState(s -> s.twist().v() < 0.001);
      State later = ofFollower.awaitState(s -> s.stamp() > stopped.stamp() + 1_000);
      assertEquals(0, stopped.pose().distanceTo(later.pose()), 0.005);

      State before = ofFollower.states().stream().filter(s -> s.stamp() <= gone).toList().getLast();
      double seconds = (gone - before.stamp()) / 1000.0 + STAND_SECONDS;
      double driven = before.pose().distanceTo(stopped.pose());
      assertTrue(driven < seconds * SPEED, "it still drove " + driven + " m");
    }
  }

  private Path configuration(String name, double x) throws IOException {
    return Files.writeString(
        folder.resolve(name + ".yaml"),
        """
        name: %s
        port: 0
        dataDir: %s
        chassis: {type: simulated, start: {x: %s, y: 1}}
        """
            .formatted(name, name, x));
  }
}
