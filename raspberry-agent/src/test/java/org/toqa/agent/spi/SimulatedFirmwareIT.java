package org.toqa.agent.spi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.DaemonProcess;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.spi.FirmwareCommand.Velocity;
import org.toqa.agent.spi.SimulatorProbe.Truth;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.motion.Segment;
import org.toqa.sim.SimulatedMicrocontroller;

/** The very hex file in a simulated ATmega128, with modelled motors, under the daemon's chassis. */
@Tag("full")
@Timeout(value = 180, threadMode = ThreadMode.SEPARATE_THREAD)
class SimulatedFirmwareIT {

  private static final Path FIRMWARE = Path.of("firmware/build").toAbsolutePath();
  private static final Pose START = new Pose(1, 2, 0.5);
  private static final Duration STAND_LIMIT = Duration.ofMillis(250);
  private static final long TICK = 20_000_000;
  private static final int SECOND = 50;

  @TempDir Path folder;
  private SimulatedMicrocontroller microcontroller;
  private SimulatorProbe probe;
  private long nanos;

  @BeforeEach
  void start() throws IOException {
    microcontroller = SimulatedMicrocontroller.start(FIRMWARE, folder);
    probe = new SimulatorProbe(microcontroller.socket());
  }

  @AfterEach
  void end() throws IOException {
    probe.close();
    microcontroller.close();
  }

  @Test
  void firmwareTellsWhatItIsAndFeels() throws IOException {
    try (Chassis chassis = chassis()) {
      probe.change("range 1 345");
      probe.change("battery 15000");
      ChassisReading now = run(chassis, Twist.ZERO, SECOND);

      assertEquals(1, now.powerCycle());
      assertEquals(START, now.placedAt());
      assertEquals(List.of(0.8, 0.345, 0.8), now.ranges());
      assertEquals((15.0 - 13.2) / (16.8 - 13.2), now.battery(), 0.02);
      assertEquals(List.of(), now.faults());
      assertEquals("r1 127.0.0.1        ", probe.truth().text("lcd1"));
      assertEquals("READY               ", probe.truth().text("lcd2"));
    }
  }

  @Test
  void cutSpiStopsTheWheelsAndTheDaemonGoesOnByItself() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      probe.live(Duration.ofSeconds(1));
      Truth stood = probe.truth();

      assertTrue(stood.rolledOn().compareTo(STAND_LIMIT) <= 0, stood.toString());
      assertEquals("STOPPED: LINK       ", stood.text("lcd2"));
      nanos += TICK;
      assertEquals(List.of("STOP_LINK"), codes(chassis.exchange(new Twist(0.25, 0, 0), nanos)));
      assertEquals(0.25, run(chassis, new Twist(0.25, 0, 0), SECOND).twist().vx(), 0.01);
    }
  }

  /** The firmware looks at its wheels, too, every 20 ms: its clock and the daemon's drift. */
  @Test
  void statusIsNewWhereverTheExchangesFallInTheFirmwaresPeriod() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      for (int phase = 0; phase < 80; phase++) {
        ChassisReading now = run(chassis, new Twist(0.25, 0, 0), 4);
        double driven = probe.truth().decimal("x");

        assertEquals(driven, now.odometry().x(), 0.25 * 0.045, "phase " + phase);
        nanos += TICK / 80;
      }
    }
  }

  @Test
  void edgeWaitsForAPerson() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      probe.change("floor 2 gone");
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      probe.change("floor 2 there");

      assertEquals(List.of("STOP_EDGE"), codes(run(chassis, Twist.ZERO, SECOND)));
      chassis.clearFaults();
      assertEquals(List.of(), codes(run(chassis, Twist.ZERO, SECOND)));
    }
  }

  @Test
  void switchedOffAndOnAgainItDoesNotClaimToKnowItsPlace() throws IOException {
    chassis().close();
    end();
    start();
    try (Chassis chassis = chassis()) {
      ChassisReading now = run(chassis, Twist.ZERO, 5);

      assertEquals(2, now.powerCycle());
      assertNull(now.placedAt());
    }
  }

  @Test
  void hungProgramIsStartedAnewAndStands() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      probe.change("program hung");
      ChassisReading now = run(chassis, new Twist(0.25, 0, 0), 2 * SECOND);

      assertEquals(2, now.powerCycle());
      assertEquals(List.of("STOP_WATCHDOG"), codes(now));
      assertTrue(now.stands());
    }
  }

  @Test
  void noByteIsLostAtTheHighestRate() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, Twist.ZERO, 5);
      for (int i = 0; i < 400; i++) {
        nanos += 7_000_000; // 64 bytes, one every 256 cycles, and the shortest pause
        chassis.exchange(new Twist(0.2, 0.1, Math.sin(i)), nanos);
      }
      byte[] frame = FrameCodec.encode(new Velocity(Twist.ZERO), 0);
      probe.exchange(Duration.ofMillis(6), frame);
      Truth truth = probe.truth();

      assertEquals(0, truth.number("overruns"));
      assertEquals(0, truth.number("rudenesses"));
      assertInBudget(truth, "spi_cycles");
      assertInBudget(truth, "clock_cycles");
      assertInBudget(truth, "uart_cycles");
    }
  }

  @Test
  void killedDaemonStopsTheWheels() throws Exception {
    Path config = folder.resolve("agent.yaml");
    Files.writeString(
        config,
        """
        name: r1
        port: 0
        dataDir: data
        chassis: {type: simulated-firmware, socket: spi.sock, start: {x: 1, y: 1}}
        """);
    try (DaemonProcess daemon = DaemonProcess.launch(config);
        DaemonProcess.Peer peer = daemon.connect()) {
      Pose start = peer.await(Hello.class, hello -> true).pose();
      peer.say(new Drive(4, null, 0, start, List.of(new Segment(0.25, 0, 60)), 1, true, 0));
      peer.await(State.class, state -> state.pose().x() > 1.1);
      daemon.kill();
    }
    Truth truth = probe.truth();
    while (truth.number("us") - truth.number("exchanged_us") < 500_000) {
      truth = probe.truth(); // its time is the wall clock's now
    }

    assertTrue(truth.rolledOn().compareTo(STAND_LIMIT) <= 0, truth.toString());
    assertTrue(truth.rolledOn().toMillis() > 100, truth.toString());
  }

  private Chassis chassis() throws IOException {
    return new FirmwareChassis(
        new SimulatorTransport(microcontroller.socket()), "r1 127.0.0.1", START, nanos);
  }

  private ChassisReading run(Chassis chassis, Twist wanted, int ticks) {
    nanos += TICK;
    ChassisReading last = chassis.exchange(wanted, nanos);
    for (int i = 1; i < ticks; i++) {
      nanos += TICK;
      last = chassis.exchange(wanted, nanos);
    }
    return last;
  }

  private static void assertInBudget(Truth truth, String interrupt) {
    long cycles = truth.number(interrupt);
    assertTrue(cycles > 0 && cycles <= 128, interrupt + " " + cycles);
  }

  private static List<String> codes(ChassisReading reading) {
    return reading.faults().stream().map(Fault::code).toList();
  }
}
