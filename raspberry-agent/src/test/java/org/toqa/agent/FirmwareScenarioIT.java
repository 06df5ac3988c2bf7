package org.toqa.agent;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.firmware.FirmwareBuild;
import org.toqa.agent.firmware.SimulatorProbe;
import org.toqa.agent.firmware.SimulatorProbe.Truth;
import org.toqa.geometry.Pose;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.motion.Segment;
import org.toqa.sim.SimulatedMicrocontroller;

/** The same drive over the simulated chassis and over the firmware in the simulated chip. */
@Tag("full")
@Timeout(120)
class FirmwareScenarioIT {

  /** A quarter circle of 0.25 m radius to the left, and a metre. */
  private static final List<Segment> SEGMENTS =
      List.of(new Segment(0.25, 1, Math.PI / 2), new Segment(0.25, 0, 4));

  @TempDir Path folder;

  @ParameterizedTest
  @EnumSource
  void arcStraightAndStopEndAtTheSamePlace(FirmwareBuild build) throws IOException {
    Pose planned = Rig.START.compose(new Pose(0.25, 1.25, Math.PI / 2));
    Pose simulated =
        drive(
            new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 1, 1),
            folder.resolve("simulated"));
    Pose byFirmware;
    Pose really;
    try (SimulatedMicrocontroller microcontroller = build.start(folder);
        SimulatorProbe probe = new SimulatorProbe(microcontroller.socket())) {
      ChassisConfig body =
          new ChassisConfig.SimulatedFirmware(microcontroller.socket(), Rig.START, true);
      byFirmware = drive(body, folder.resolve("firmware"));
      Truth truth = probe.truth();
      really =
          Rig.START.compose(
              new Pose(truth.decimal("x"), truth.decimal("y"), truth.decimal("theta")));
    }

    DrivingTest.assertNear(simulated, byFirmware, 0.005, 0.01);
    DrivingTest.assertNear(simulated, really, 0.005, 0.01);
    DrivingTest.assertNear(planned, really, 0.005, 0.01);
  }

  private static Pose drive(ChassisConfig body, Path data) {
    try (Rig rig = new Rig(data, body)) {
      rig.advance(Duration.ofMillis(500));
      TestServer server = rig.connect();
      server.assertAccepted(new Drive(1, null, 0, Rig.START, SEGMENTS, SEGMENTS.size(), true, 0));
      server.advance(Duration.ofSeconds(10));
      return server.pose();
    }
  }
}
