package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.Segment;

/** A body that stopped itself moves again by a person's word and a new drive, and by no other. */
class ClearedStopTest {
  private static final Segment METRE = new Segment(0.25, 0, 4);
  private static final Duration MINUTE = Duration.ofMinutes(1);

  @TempDir Path folder;
  private Rig rig;
  private TestServer server;

  @BeforeEach
  void driveAndStop() {
    rig =
        new Rig(
            folder,
            new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1),
            StoppingChassis::new);
    server = rig.connect();
    server.assertAccepted(TestServer.drive(10, 5L, 2, Rig.START, List.of(METRE, METRE)));
    server.advance(Duration.ofSeconds(2));
    body().stop("STOP_SWITCH");
    server.advance(Duration.ofSeconds(1));
  }

  @AfterEach
  void close() {
    rig.close();
  }

  private StoppingChassis body() {
    return (StoppingChassis) rig.body();
  }

  @Test
  void resumeClearsNothing() {
    Pose stopped = server.pose();
    server.assertAccepted(new Hold(11));
    server.assertAccepted(new Resume(12));
    server.advance(Duration.ofSeconds(5));

    assertEquals(List.of(), body().cleared());
    assertStopped("STOP_SWITCH");
    assertEquals(stopped, server.pose());
  }

  @Test
  void clearedRobotStaysWhereItIsUntilANewDrive() {
    Pose stopped = server.pose();
    server.assertAccepted(new Clear(11, List.of("STOP_SWITCH")));
    server.advance(Duration.ofSeconds(5));

    State state = server.state();
    assertEquals(List.of(Set.of("STOP_SWITCH")), body().cleared());
    assertEquals(Mode.IDLE, state.mode());
    assertEquals(List.of(), state.errors());
    assertEquals(0, state.drive());
    assertEquals(5L, state.task());
    assertEquals(2, state.phase());
    assertEquals(stopped, state.pose());

    server.assertAccepted(TestServer.drive(12, 5L, 2, stopped, List.of(METRE)));
    server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertEquals(stopped.x() + 1, server.pose().x(), 0.002);
  }

  @Test
  void driveThatWasDroppedStaysDroppedOverARestart() {
    server.assertAccepted(new Clear(11, List.of("STOP_SWITCH")));
    server.advance(Duration.ofSeconds(1));
    rig.restart();

    assertEquals(List.of(), rig.connect().state().errors()); // it knows of no drive to give up
  }

  @Test
  void followerThatIsClearedFollowsNoMore() {
    server.assertAccepted(new Clear(11, List.of("STOP_SWITCH")));
    server.advance(Duration.ofSeconds(1));
    server.assertAccepted(new Follow(12, 5, "r9", null, new Vec2(-0.5, 0), 0.5, null));
    body().stop("STOP_EDGE");
    server.advance(Duration.ofSeconds(1));
    assertEquals(Role.FOLLOWER, server.state().role());

    server.assertAccepted(new Clear(13, List.of("STOP_EDGE")));
    server.advance(Duration.ofSeconds(1));
    assertEquals(Role.ALONE, server.state().role());
    assertEquals(0, server.state().drive());
  }

  @Test
  void lateAndRepeatedCommandsClearNothing() {
    server.assertAccepted(new Clear(10, List.of("STOP_SWITCH"))); // the number of its drive
    server.advance(Duration.ofSeconds(1));
    assertEquals(List.of(), body().cleared());
    assertStopped("STOP_SWITCH");

    server.assertAccepted(new Clear(11, List.of("STOP_SWITCH")));
    server.advance(Duration.ofSeconds(1));
    body().stop("STOP_SWITCH");
    server.assertAccepted(new Clear(11, List.of("STOP_SWITCH")));
    server.assertAccepted(new Resume(11));
    server.advance(Duration.ofSeconds(1));
    assertEquals(List.of(Set.of("STOP_SWITCH")), body().cleared());
    assertStopped("STOP_SWITCH");
  }

  @Test
  void whatThePersonWasNotShownIsNotCleared() {
    body().stop("STOP_EDGE");
    server.advance(Duration.ofSeconds(1));
    assertEquals(
        "What stops the robot has changed; it is STOP_EDGE, STOP_SWITCH now.",
        server.rejectReason(new Clear(11, List.of("STOP_SWITCH"))));
    server.advance(Duration.ofSeconds(1));

    assertEquals(List.of(), body().cleared());
    assertStopped("STOP_EDGE", "STOP_SWITCH");
    server.assertAccepted(new Clear(12, List.of("STOP_SWITCH", "STOP_EDGE")));
  }

  @Test
  void robotThatNothingStopsHasNothingToClear() {
    server.assertAccepted(new Clear(11, List.of("STOP_SWITCH")));
    server.advance(Duration.ofSeconds(1));

    assertEquals(
        "Nothing stops the robot that a person could clear.",
        server.rejectReason(new Clear(12, List.of())));
  }

  private void assertStopped(String... codes) {
    State state = server.state();
    assertEquals(Mode.ERROR, state.mode());
    assertEquals(List.of(codes), state.errors().stream().map(Fault::code).toList());
    assertTrue(state.errors().stream().allMatch(Fault::clearable));
  }
}
