package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.firmware.FirmwareCommand.Clear;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.motion.ThreeWheelKinematics;
import org.toqa.sim.SimulatedMicrocontroller;

/** A robot that is not as the default, in the simulated microcontroller. */
@Tag("full")
@Timeout(60)
class SettingsIT {

  private static final long TICK = 20_000_000;
  private static final int SECOND = 50;
  private static final Twist AHEAD = new Twist(0.25, 0, 0);

  /** Wheels of 0.05 m, and a third floor sensor that looks at a dark floor. */
  private static final FirmwareSettings SETTINGS =
      new FirmwareSettings(new ThreeWheelKinematics(0.05, 0.10), List.of(1.0, 1.0, 0.4, 1.0, 1.0));

  @TempDir Path folder;

  @SuppressWarnings("NullAway.Init") // by start
  private SimulatedMicrocontroller microcontroller;

  @SuppressWarnings("NullAway.Init")
  private SimulatorProbe probe;

  private long nanos;

  @BeforeEach
  void start() throws IOException {
    microcontroller = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
    probe = new SimulatorProbe(microcontroller.socket());
    for (int wheel = 0; wheel < 3; wheel++) {
      probe.change("size " + wheel + " 250000"); // 0.05 m are 1.25 times 0.04 m
    }
    probe.change("floor_mv 2 500");
  }

  @AfterEach
  void end() throws IOException {
    probe.close();
    microcontroller.close();
  }

  @Test
  void robotOfOtherMeasuresDrivesAsFarAsItIsToldAndKeepsThem() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, Twist.ZERO, SECOND);
      chassis.clearStops(Set.of("STOP_EDGE")); // by the default thresholds it saw no floor
      run(chassis, Twist.ZERO, SECOND);
      ChassisReading now = run(chassis, AHEAD, 2 * SECOND);

      assertEquals(List.of(), now.faults());
      assertEquals(0.25, now.twist().vx(), 0.01);
      assertEquals(probe.truth().decimal("x"), now.odometry().x(), 0.012);
      assertEquals(0.5, probe.truth().decimal("x"), 0.03);
    }
    end();
    start(); // from its EEPROM
    try (SimulatorTransport spi = new SimulatorTransport(microcontroller.socket())) {
      for (int i = 1; i <= 3 * SECOND; i++) {
        FirmwareCommand command =
            i < SECOND ? new Clear(Set.of(StopReason.POWER_UP), false) : new Velocity(AHEAD);
        spi.exchange(FrameCodec.encode(command, i % FrameCodec.SEQUENCES), nanos += TICK);
      }
      assertEquals(0.5, probe.truth().decimal("x"), 0.03);
    }
  }

  @Test
  void hotMotorDriverIsToldWithItsTemperature() throws IOException {
    try (Chassis chassis = chassis()) {
      probe.change("temperature 91");
      ChassisReading now = run(chassis, Twist.ZERO, SECOND);
      List<String> heat =
          now.faults().stream()
              .filter(fault -> fault.code().equals("STOP_HEAT"))
              .map(Fault::text)
              .toList();
      assertEquals(List.of("The motor driver is too hot. It has 91 degrees Celsius."), heat);
    }
  }

  @Test
  void secondSwitchShowsBatteryAndTemperatureOnTheDisplay() throws IOException {
    probe.change("floor_mv 2 3000");
    try (Chassis chassis = chassis()) {
      run(chassis, Twist.ZERO, SECOND);
      assertEquals("READY               ", probe.truth().text("lcd2"));
      probe.change("switch 2 pressed");
      run(chassis, Twist.ZERO, 10);
      probe.change("switch 2 released");
      run(chassis, Twist.ZERO, SECOND);
      String shown = probe.truth().text("lcd2");
      assertTrue(shown.matches("1[56]\\.\\d\\d V  025 C +"), shown);
    }
  }

  private Chassis chassis() throws IOException {
    return new FirmwareChassis(
        new SimulatorTransport(microcontroller.socket()), "r1", null, true, SETTINGS, null, nanos);
  }

  private ChassisReading run(Chassis chassis, Twist wanted, int ticks) {
    ChassisReading last = chassis.exchange(wanted, nanos += TICK);
    for (int i = 1; i < ticks; i++) {
      last = chassis.exchange(wanted, nanos += TICK);
    }
    return last;
  }
}
