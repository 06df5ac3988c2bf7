package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.LeaderPose;

class MotionLimitsTest {

  private static final MotionLimits LIMITS = new MotionLimits(0.5, 2, 1, 1);

  @TempDir Path folder;

  @Test
  void whatIsTooFastIsDrivenMoreSlowlyOnTheSameCurve() {
    assertEquals(new Twist(0.3, 0.4, 1), LIMITS.clampedTwist(new Twist(0.6, 0.8, 2)));
    assertEquals(new Twist(0.1, 0, -2), LIMITS.clampedTwist(new Twist(0.2, 0, -4)));
    assertEquals(new Twist(0.3, -0.4, 2), LIMITS.clampedTwist(new Twist(0.3, -0.4, 2)));
    assertEquals(Twist.ZERO, LIMITS.clampedTwist(Twist.ZERO));
  }

  @Test
  void followerIsNoFasterThanItsLimitsWhateverItsLeaderSays() {
    MotionRecorder witness = new MotionRecorder();
    ChassisConfig body =
        new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1, witness);
    try (Rig rig = new Rig(folder, body)) {
      TestServer server = rig.connect();
      server.assertAccepted(new Follow(1, 5, "r9", null, new Vec2(-0.5, 0), 0.5, null));
      TestServer leader = rig.connect();
      for (int word = 1; word <= 20; word++) {
        Pose ahead = server.pose().compose(new Pose(0.5, 0, 0));
        leader.send(new LeaderPose(5, word, 0, ahead, new Speed(0.8, 0)));
        leader.synchroniseAsLeader();
        server.advance(Duration.ofMillis(100));
      }

      assertTrue(witness.fastest() > 0.9 * Rig.LIMITS.speed(), witness.fastest() + " m/s");
      assertTrue(witness.fastest() < 1.02 * Rig.LIMITS.speed(), witness.fastest() + " m/s");
    }
  }
}
