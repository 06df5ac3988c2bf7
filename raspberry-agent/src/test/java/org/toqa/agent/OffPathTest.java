package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.motion.Segment;

/** A robot that comes off its path: it corrects, and beyond the bound it stands. */
class OffPathTest {
  private static final Segment METRE = new Segment(0.25, 0, 4);
  private static final Duration MINUTE = Duration.ofMinutes(1);

  @TempDir Path folder;

  @SuppressWarnings("NullAway.Init") // by connect
  private Rig rig;

  @SuppressWarnings("NullAway.Init")
  private TestServer server;

  @SuppressWarnings("NullAway.Init")
  private SimulatedChassis body;

  @BeforeEach
  void connect() {
    rig = new Rig(folder, new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1));
    body = (SimulatedChassis) rig.body();
    server = rig.connect();
  }

  @AfterEach
  void close() {
    rig.close();
  }

  @Test
  void robotShovedWithinTheBoundCorrectsWhileItDrives() {
    driveTwoMetres();
    body.shove(new Vec2(0, 0.04));
    server.advance(Duration.ofMillis(1_500));

    State corrected = server.state();
    assertEquals(Rig.START.y(), corrected.pose().y(), 0.005);
    assertTrue(corrected.twist().v() > 0.2, "it drives on: " + corrected.twist());
    assertEquals(
        List.of(),
        server.received(State.class).stream().flatMap(s -> s.errors().stream()).toList());
  }

  @Test
  void robotShovedBeyondTheBoundStandsAndSaysWhy() {
    driveTwoMetres();
    body.shove(new Vec2(0, 0.06));
    server.advance(Duration.ofSeconds(1));
    State stopped = server.state();
    server.advance(Duration.ofSeconds(10));

    assertEquals(
        new Fault("OFF_WAY", "The robot is 0.06 m off its path; it stands.", false),
        stopped.errors().getFirst());
    assertEquals(0, stopped.twist().v(), 0.01);
    assertEquals(Mode.DRIVING, stopped.mode());
    assertEquals(0, stopped.pose().distanceTo(server.pose()), 0.003, "it moves");
  }

  @Test
  void robotThatStoodGoesOnByANewPathFromWhereItIs() {
    driveTwoMetres();
    body.shove(new Vec2(0, -0.08));
    server.advanceUntil(OffPathTest::isOffPath, MINUTE);
    server.advance(Duration.ofSeconds(1));
    server.assertAccepted(new Cancel(2, 5L));
    State free = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertEquals(List.of(), free.errors());

    server.assertAccepted(TestServer.drive(3, 5L, 1, free.pose(), List.of(METRE)));
    State end = server.advanceUntil(s -> s.mode() == Mode.IDLE, MINUTE);
    assertEquals(free.pose().x() + 1, end.pose().x(), 0.003);
    assertEquals(Rig.START.y() - 0.08, end.pose().y(), 0.003);
  }

  @Test
  void robotWhoseWheelsAreBlockedIsOnItsPath() {
    driveTwoMetres();
    body.shove(new Vec2(-0.15, 0));
    server.advance(Duration.ofSeconds(12));

    assertEquals(
        List.of(),
        server.received(State.class).stream().flatMap(s -> s.errors().stream()).toList());
    assertEquals(Rig.START.x() + 2, server.pose().x(), 0.003);
  }

  @Test
  void driveThatBeginsBesideTheRobotByMoreThanTheBoundIsRefused() {
    Pose aside = Rig.START.compose(new Pose(0, 0.06, 0));
    String reason = server.rejectReason(TestServer.drive(1, 5L, 1, aside, List.of(METRE)));
    assertTrue(reason.startsWith("The drive starts 0.06 m"), reason);
  }

  private void driveTwoMetres() {
    server.assertAccepted(TestServer.drive(1, 5L, 1, Rig.START, List.of(METRE, METRE)));
    server.advance(Duration.ofSeconds(3));
  }

  private static boolean isOffPath(State state) {
    return state.errors().stream().anyMatch(fault -> fault.code().equals("OFF_WAY"));
  }
}
