package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedChassis;
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

  /** Where they end, from where they begin. */
  private static final Pose GOAL = new Pose(0.25, 1.25, Math.PI / 2);

  private static final double TICK = Chassis.TICK.toNanos() / 1e9;

  @TempDir Path folder;

  /** What the wheels are larger than robot and daemon take them to be, in millionths. */
  private static final int[] HIDDEN_ERRORS = {4_000, -3_000, 2_000};

  @ParameterizedTest
  @EnumSource
  void bothBodiesDriveTheSegmentsByThemselvesAndEndAtTheSamePlace(FirmwareBuild build)
      throws IOException {
    Pose planned = Rig.START.compose(GOAL);
    Drives simulated = driveSimulated(new int[3]);
    Drives byFirmware = driveByFirmware(build, new int[3]);

    DrivingTest.assertNear(simulated.reported(), byFirmware.reported(), 0.005, 0.01);
    DrivingTest.assertNear(simulated.really(), byFirmware.really(), 0.005, 0.01);
    DrivingTest.assertNear(planned, byFirmware.really(), 0.005, 0.01);
    for (Drives drives : List.of(simulated, byFirmware)) {
      // 5.57 s as planned; velocities only for the last millimetres
      assertTrue(drives.byItself() > 5.5 / TICK && drives.streamed() < 0.005, "" + drives);
    }
  }

  @Test
  void hiddenErrorsOfTheWheelsCarryBothBodiesToTheSamePlace() throws IOException {
    Drives simulated = driveSimulated(HIDDEN_ERRORS);
    Drives byFirmware = driveByFirmware(FirmwareBuild.LM629_AT_16_MHZ, HIDDEN_ERRORS);

    assertTrue(simulated.really().distanceTo(simulated.reported()) > 0.003, simulated.toString());
    DrivingTest.assertNear(simulated.really(), byFirmware.really(), 0.005, 0.01);
  }

  /**
   * A drive that has ended.
   *
   * @param reported where the robot takes itself to be, map frame
   * @param really where it is
   * @param byItself ticks in which the body had a path to drive
   * @param streamed how far from the goal it was at most when it was given a velocity, metres
   */
  private record Drives(Pose reported, Pose really, int byItself, double streamed) {}

  private Drives driveSimulated(int[] errors) {
    ChassisConfig body = new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 1, 1);
    CommandCount count = new CommandCount();
    try (Rig rig = new Rig(folder.resolve("simulated"), body, count::watch)) {
      SimulatedChassis chassis = (SimulatedChassis) count.body();
      for (int wheel = 0; wheel < errors.length; wheel++) {
        chassis.setWheelSlip(wheel, -errors[wheel] * 1e-6);
      }
      Pose reported = drive(rig);
      return new Drives(reported, chassis.truePose(), count.paths, count.streamed);
    }
  }

  private Drives driveByFirmware(FirmwareBuild build, int[] errors) throws IOException {
    try (SimulatedMicrocontroller microcontroller = build.start(folder);
        SimulatorProbe probe = new SimulatorProbe(microcontroller.socket())) {
      for (int wheel = 0; wheel < errors.length; wheel++) {
        probe.change("size " + wheel + " " + errors[wheel]);
      }
      ChassisConfig body =
          new ChassisConfig.SimulatedFirmware(microcontroller.socket(), Rig.START, true);
      CommandCount count = new CommandCount();
      try (Rig rig = new Rig(folder.resolve("firmware"), body, count::watch)) {
        Pose reported = drive(rig);
        Truth truth = probe.truth();
        Pose moved = new Pose(truth.decimal("x"), truth.decimal("y"), truth.decimal("theta"));
        return new Drives(reported, Rig.START.compose(moved), count.paths, count.streamed);
      }
    }
  }

  private static Pose drive(Rig rig) {
    rig.advance(Duration.ofMillis(500));
    TestServer server = rig.connect();
    server.assertAccepted(new Drive(1, null, 0, Rig.START, SEGMENTS, SEGMENTS.size(), true, 0));
    server.advance(Duration.ofSeconds(10));
    return server.pose();
  }

  /** Watches what a body is commanded. */
  private static final class CommandCount {
    private @Nullable Chassis body;
    private int paths;
    private double streamed;
    private long lastNanos;

    Chassis body() {
      return Objects.requireNonNull(body);
    }

    Chassis watch(Chassis watched) {
      body = watched;
      return new Chassis() {
        @Override
        public ChassisReading exchange(ChassisCommand command, long nanos) {
          // the daemon also ticks while no time passes, to hear what it is told
          paths += command instanceof DrivePath && nanos > lastNanos ? 1 : 0;
          lastNanos = nanos;
          ChassisReading reading = watched.exchange(command, nanos);
          if (command instanceof MoveAt && !command.equals(MoveAt.STANDSTILL)) {
            streamed = Math.max(streamed, reading.odometry().distanceTo(GOAL));
          }
          return reading;
        }

        @Override
        public void close() {
          watched.close();
        }
      };
    }
  }
}
