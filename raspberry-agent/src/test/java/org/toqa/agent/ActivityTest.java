package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.LeaderPose;
import org.toqa.motion.Segment;

/**
 * A robot drives alone, leads or follows, and what one activity leaves does not hinder the next.
 */
class ActivityTest {

  private static final long TASK = 5;
  private static final Follow FOLLOW =
      new Follow(9, TASK, "r9", null, new Vec2(-0.5, 0), 0.5, null);

  @TempDir Path folder;

  @Test
  void robotWhoseLastDriveWasCancelledFollowsItsLeader() {
    MotionRecorder witness = new MotionRecorder();
    ChassisConfig body =
        new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1, witness);
    try (Rig rig = new Rig(folder, body)) {
      TestServer server = rig.connect();
      List<Segment> segments = List.of(new Segment(0.2, 0, 5));
      server.assertAccepted(new Drive(1, null, 0, Rig.START, segments, 1, true, 0));
      server.advance(Duration.ofSeconds(1));
      server.assertAccepted(new Cancel(2, null));
      server.advance(Duration.ofSeconds(2));
      assertEquals(Role.ALONE, server.state().role());

      server.assertAccepted(FOLLOW);
      double before = server.pose().x();
      TestServer leader = rig.connect();
      for (int seq = 1; seq <= 10; seq++) {
        Pose ahead = server.pose().compose(new Pose(0.55, 0, 0));
        leader.send(new LeaderPose(TASK, seq, 0, ahead, new Speed(0.2, 0)));
        leader.synchroniseAsLeader();
        server.advance(Duration.ofMillis(100));
      }
      // a second at 0.2 m/s and more
      assertTrue(server.pose().x() > before + 0.1, server.pose() + " after " + before);
    }
  }

  @Test
  void worldWaitsForALeaderOnlyWhileItIsFollowedAndNotLost() {
    try (Rig rig = new Rig(folder)) {
      TestServer server = rig.connect();
      server.assertAccepted(FOLLOW);
      TestServer leader = rig.connect();
      Pose ahead = server.pose().compose(new Pose(0.5, 0, 0));
      leader.send(new LeaderPose(TASK, 1, 0, ahead, new Speed(0, 0)));
      leader.synchroniseAsLeader();
      server.advance(Duration.ofMillis(200));
      assertFalse(rig.isWaitingForLeader());
      server.advance(Duration.ofMillis(100));
      assertTrue(rig.isWaitingForLeader());
      server.advance(Duration.ofMillis(500)); // lost after 0.6 s
      assertFalse(rig.isWaitingForLeader());

      leader.send(new LeaderPose(TASK, 2, 0, ahead, new Speed(0, 0)));
      leader.synchroniseAsLeader();
      server.advance(Duration.ofMillis(300));
      assertTrue(rig.isWaitingForLeader());
      server.assertAccepted(new Cancel(10, TASK));
      assertFalse(rig.isWaitingForLeader());
    }
  }

  @Test
  void robotThatFollowsLeadsNoMore() {
    try (Rig rig = new Rig(folder)) {
      TestServer server = rig.connect();
      List<Follower> nobody = List.of(new Follower("r2", "127.0.0.1", 1, null));
      server.assertAccepted(new Lead(1, TASK, 0.05, nobody, null));
      assertEquals(Role.LEADER, role(server));

      server.assertAccepted(FOLLOW);
      assertEquals(Role.FOLLOWER, role(server));
      server.assertAccepted(new Cancel(10, TASK));
      assertEquals(Role.ALONE, role(server));
    }
  }

  /** After the time in which each robot reports its state once. */
  private static Role role(TestServer server) {
    server.advance(Duration.ofMillis(200));
    return server.state().role();
  }
}
