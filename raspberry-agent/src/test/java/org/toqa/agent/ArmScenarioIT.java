package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ArmConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.firmware.FirmwareBuild;
import org.toqa.agent.firmware.SimulatorProbe;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmAction;
import org.toqa.arm.ArmStep;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Acted;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.AckActed;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Frame;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Segment;
import org.toqa.sim.SimulatedMicrocontroller;

/** The same acts over the simulated chassis and over the firmware in the simulated chip. */
@Tag("full")
@Timeout(180)
class ArmScenarioIT {

  private static final Duration MINUTE = Duration.ofMinutes(1);
  private static final JointLimits JOINT =
      new JointLimits(Math.toRadians(-160), Math.toRadians(160), Math.PI / 2, Math.PI);
  private static final Arm ARM =
      new Arm(
          0.3,
          0.25,
          new Pose(0.05, 0, 0),
          JOINT,
          JOINT,
          2,
          new JointAngles(Math.toRadians(120), Math.toRadians(-150)));

  @TempDir Path folder;

  /**
   * What the server hears.
   *
   * @param steps in their order
   * @param acted how the acts ended
   * @param seconds until then
   * @param held how the arm stood on hold
   */
  private record Story(
      List<ArmStep> steps, List<Acted> acted, double seconds, JointAngles held, Pose end) {}

  @Test
  void serverHearsTheSameOfBothArms() throws IOException {
    Story simulated =
        tell(new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1), "simulated");
    Story byFirmware;
    try (SimulatedMicrocontroller chip = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
        SimulatorProbe probe = new SimulatorProbe(chip.socket())) {
      byFirmware =
          tell(new ChassisConfig.SimulatedFirmware(chip.socket(), Rig.START, true), "firmware");
      assertEquals(1, probe.truth().decimal("grasps"));
      assertEquals(1, probe.truth().decimal("releases"));
    }
    assertEquals(simulated.steps(), byFirmware.steps());
    assertEquals(simulated.acted().size(), byFirmware.acted().size());
    for (int i = 0; i < simulated.acted().size(); i++) {
      Acted one = simulated.acted().get(i);
      Acted other = byFirmware.acted().get(i);
      assertEquals(one.failure(), other.failure());
      assertEquals(one.act(), other.act());
      if (one.weight() == null) {
        assertNull(other.weight());
      } else {
        assertEquals(one.weight(), Objects.requireNonNull(other.weight()), 0.01);
      }
    }
    assertEquals(simulated.seconds(), byFirmware.seconds(), 1.5);
    assertEquals(0, simulated.held().minus(byFirmware.held()).largest(), 0.2);
    DrivingTest.assertNear(simulated.end(), byFirmware.end(), 0.01, 0.02);
  }

  /** Picks up with a hold on the way, drives, is told a place out of reach, and puts down. */
  private Story tell(ChassisConfig body, String name) throws IOException {
    try (Rig rig =
        new Rig(
            folder.resolve(name),
            DriveKind.OMNI,
            body,
            chassis -> chassis,
            new ArmConfig(ARM, null))) {
      TestServer server = rig.connect();
      server.advance(Duration.ofSeconds(1));
      double begun = server.state().stamp() / 1e3;
      List<Acted> acted = new ArrayList<>();
      server.assertAccepted(act(1, ArmAction.PICK, new Vec2(0.45, 0.1)));
      server.advance(Duration.ofMillis(900));
      server.assertAccepted(new Hold(2));
      server.advance(Duration.ofSeconds(2));
      JointAngles held = arm(server.state()).joints();
      server.advance(Duration.ofSeconds(1));
      assertEquals(0, arm(server.state()).joints().minus(held).largest(), 1e-3);
      server.assertAccepted(new Resume(3));
      acted.add(end(server));
      assertTrue(arm(server.state()).load() != null);
      server.send(new AckActed(1));

      server.assertAccepted(
          TestServer.drive(4, 5L, 2, Rig.START, List.of(new Segment(0.25, 0, 2))));
      server.advanceUntil(state -> state.mode() == Mode.IDLE, MINUTE);
      server.assertAccepted(act(5, ArmAction.PLACE, new Vec2(2, 0)));
      acted.add(end(server));
      server.send(new AckActed(5));
      server.assertAccepted(act(6, ArmAction.PLACE, new Vec2(0.4, -0.1)));
      acted.add(end(server));
      List<ArmStep> steps =
          server.received(State.class).stream()
              .map(state -> arm(state).step())
              .filter(Objects::nonNull)
              .toList();
      return new Story(
          withoutRepeats(steps), acted, server.state().stamp() / 1e3 - begun, held, server.pose());
    }
  }

  private static List<ArmStep> withoutRepeats(List<ArmStep> steps) {
    List<ArmStep> once = new ArrayList<>();
    for (ArmStep step : steps) {
      if (once.isEmpty() || once.getLast() != step) {
        once.add(step);
      }
    }
    return once;
  }

  private static Act act(long seq, ArmAction action, Vec2 place) {
    return new Act(seq, 5, action == ArmAction.PICK ? 1 : 2, action, Frame.ROBOT, place, 1.5);
  }

  private static Acted end(TestServer server) {
    server.advanceUntil(state -> arm(state).act() == null, MINUTE);
    return server.received(Acted.class).getLast();
  }

  private static ArmState arm(State state) {
    return Objects.requireNonNull(state.arm());
  }
}
