package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.agent.DaemonProcess;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.agent.firmware.SimulatorProbe.Truth;
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
@ParameterizedClass
@EnumSource
class SimulatedFirmwareIT {

  private static final Pose START = new Pose(1, 2, 0.5);
  private static final Duration STAND_LIMIT = Duration.ofMillis(250);
  private static final Duration BRAKE_LIMIT = Duration.ofMillis(50);

  /** Micros that the master is silent at least, and 100 more. */
  private static final int SHORTEST_PAUSE = 2_100;

  private static final long TICK = 20_000_000;
  private static final int SECOND = 50;

  private final FirmwareBuild build;
  @TempDir Path folder;
  private SimulatedMicrocontroller microcontroller;
  private SimulatorProbe probe;
  private long nanos;

  SimulatedFirmwareIT(FirmwareBuild build) {
    this.build = build;
  }

  @BeforeEach
  void start() throws IOException {
    microcontroller = build.start(folder);
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
      ChassisReading now = run(chassis, Twist.ZERO, SECOND);

      assertEquals(1, now.powerCycle());
      assertEquals(START, now.startPose());
      assertEquals(List.of(0.8, 0.345, 0.8), now.ranges());
      assertEquals(0.77, now.battery(), 0.02); // 16 V: cells of 4.00 V at rest
      assertEquals(List.of(), now.faults());
      assertEquals("r1 127.0.0.1        ", probe.truth().text("lcd1"));
      assertEquals("READY               ", probe.truth().text("lcd2"));
    }
  }

  @Test
  void cutSpiStopsTheWheelsAndTheDaemonGoesOnByItself() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      probe.advance(Duration.ofSeconds(1));
      Truth stopped = probe.truth();

      assertTrue(stopped.rolledOn().compareTo(STAND_LIMIT) <= 0, stopped.toString());
      assertEquals("STOPPED: LINK       ", stopped.text("lcd2"));
      nanos += TICK;
      assertEquals(List.of("STOP_LINK"), codes(chassis.exchange(new Twist(0.25, 0, 0), nanos)));
      assertEquals(0.25, run(chassis, new Twist(0.25, 0, 0), SECOND).twist().vx(), 0.01);
    }
  }

  /** From the fastest that the wheels are told to turn, with a load of 0.4 of the robot's mass. */
  @Test
  void cutSpiStopsALoadedRobotFromItsHighestSpeed() throws IOException {
    try (Chassis chassis = chassis()) {
      probe.change("load 40");
      run(chassis, new Twist(1, 1, 9.9), SECOND);
      probe.advance(Duration.ofSeconds(1));
      Truth stopped = probe.truth();

      assertTrue(stopped.rolledOn().compareTo(STAND_LIMIT) <= 0, stopped.toString());
      assertTrue(stopped.rolledOn().toMillis() > 200, stopped.toString());
    }
  }

  @ParameterizedTest
  @CsvSource({"0, 0, 9.9", "1, 0, 0", "0.5, 0, 3.5", "-0.2, 0.3, -0.5", "0, 0.1, 0"})
  void pressedSwitchStopsTheWheels(double vx, double vy, double w) throws IOException {
    try (Chassis chassis = chassis()) {
      for (String load : List.of("load 0", "load 20", "load 40")) {
        probe.change(load);
        run(chassis, new Twist(vx, vy, w), SECOND);
        Duration pressed = probe.truth().now();
        probe.change("switch pressed");
        probe.advance(Duration.ofMillis(150));
        Truth stopped = probe.truth();
        Duration took = stopped.moved().minus(pressed);

        assertTrue(took.compareTo(BRAKE_LIMIT) <= 0, load + " " + took + " " + stopped);
        assertTrue(took.toMillis() > 5, load + " " + took + " " + stopped);
        probe.change("switch released");
        clear(chassis);
      }
    }
  }

  @Test
  void blockedWheelIsAStallAndWaitsForAPerson() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      probe.change("wheel 2 blocked");
      ChassisReading now = run(chassis, new Twist(0.25, 0, 0), SECOND);

      assertEquals(List.of("STOP_STALL"), codes(now));
      assertTrue(now.isStanding());
      probe.change("wheel 2 free");
      clear(chassis);
      assertEquals(0.25, run(chassis, new Twist(0.25, 0, 0), SECOND).twist().vx(), 0.01);
    }
  }

  @Test
  void hotMotorDriverStopsTheWheelsAndWaitsForAPerson() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      Duration hot = probe.truth().now();
      probe.change("heat on");
      probe.advance(Duration.ofMillis(150));
      Truth stopped = probe.truth();

      assertTrue(stopped.moved().minus(hot).compareTo(BRAKE_LIMIT) <= 0, stopped.toString());
      assertEquals("STOPPED: HEAT       ", stopped.text("lcd2"));
      probe.change("heat off");
      assertTrue(codes(run(chassis, new Twist(0.25, 0, 0), SECOND)).contains("STOP_HEAT"));
      clear(chassis);
      assertEquals(0.25, run(chassis, new Twist(0.25, 0, 0), SECOND).twist().vx(), 0.01);
    }
  }

  /** A motor that starts pulls the voltage down for a moment, too. */
  @Test
  void batteryThatIsLowForASecondStopsTheWheelsAndADipDoesNot() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, new Twist(0.25, 0, 0), SECOND);
      probe.change("battery 12000");
      run(chassis, new Twist(0.25, 0, 0), SECOND / 2);
      probe.change("battery 15000");
      ChassisReading dipped = run(chassis, new Twist(0.25, 0, 0), 2 * SECOND);
      assertEquals(List.of(), codes(dipped));
      assertEquals(0.25, dipped.twist().vx(), 0.01);

      probe.change("battery 12000");
      ChassisReading low = run(chassis, new Twist(0.25, 0, 0), 3 * SECOND);
      assertEquals(List.of("STOP_BATTERY"), codes(low));
      assertTrue(low.isStanding());
      assertEquals(0, low.battery(), 0.01);
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
  void silentRangeSensorsAreAFaultUntilTheySpeakAgain() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, Twist.ZERO, SECOND);
      probe.change("ranges silent");
      assertEquals(List.of("RANGE_SENSORS"), codes(run(chassis, Twist.ZERO, SECOND)));
      probe.change("ranges well");
      assertEquals(List.of(), codes(run(chassis, Twist.ZERO, SECOND)));
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
      chassis.clearStops(Set.of("STOP_SWITCH"));
      assertEquals(List.of("STOP_EDGE"), codes(run(chassis, Twist.ZERO, SECOND)));
      chassis.clearStops(Set.of("STOP_EDGE"));
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
      assertNull(now.startPose());
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
      assertTrue(now.isStanding());
    }
  }

  /** All wheels turn at the rated speed, 5,148 edges a second each and all at once. */
  @Test
  void noByteAndNoCountIsLostAtTheHighestRates() throws IOException {
    try (SimulatorTransport spi = new SimulatorTransport(microcontroller.socket())) {
      int badFrames = untilItHasStarted(spi).badFrames();
      Truth started = probe.truth(); // bytes that came before are nobody's
      for (int wheel = 0; wheel < 3; wheel++) {
        probe.change("wheel " + wheel + " pushed");
      }
      FirmwareStatus status = exchangeAll(spi, 800);
      Truth truth = probe.truth();

      assertEquals(0, status.lostBytes());
      assertEquals(badFrames, status.badFrames());
      assertEquals(started.number("overruns"), truth.number("overruns"));
      assertEquals(started.number("late_answers"), truth.number("late_answers"));
      assertTrue(truth.number("answer_cycles") <= 192, truth.toString());
      assertEquals(0, truth.number("rudenesses"));
      assertInBudget(truth, "spi_cycles", 128);
      assertInBudget(truth, "uart_cycles", 128);
      for (int wheel = 1; build.isPwm() && wheel <= 3; wheel++) {
        assertInBudget(truth, "encoder" + wheel + "_cycles", 40);
      }
      for (int wheel = 0; wheel < 3; wheel++) {
        // told as it was when the exchange began, and that 15 ms before: 10,296 counts a second
        double behind = truth.decimal("counts" + (wheel + 1)) - status.counts().get(wheel);
        assertEquals(truth.decimal("counts1") - status.counts().get(0), behind, 2);
        assertTrue(behind >= 0 && behind < 10_296 * 0.040, truth + " " + status);
      }
    }
  }

  /** The shortest pause ends while the main loop is still at the wheels, and has not noticed it. */
  @Test
  void frameThatComesBeforeItsPauseIsNoticedIsWhole() throws IOException {
    try (SocketChannel master =
        SocketChannel.open(UnixDomainSocketAddress.of(microcontroller.socket()))) {
      exchange(master, 0, 200_000); // until it has started
      for (int wheel = 0; wheel < 3; wheel++) {
        probe.change("wheel " + wheel + " pushed");
      }
      exchange(master, 1, 20_000);
      int badFrames = exchange(master, 2, 20_000).orElseThrow().badFrames();
      Random random = new Random(1);
      for (int i = 3; i < 1_500; i++) {
        exchange(master, i % FrameCodec.SEQUENCES, SHORTEST_PAUSE + random.nextInt(6_000));
      }
      exchange(master, 0, 20_000);
      FirmwareStatus status = exchange(master, 1, 20_000).orElseThrow();

      assertEquals(badFrames, status.badFrames());
      assertEquals(0, status.lostBytes());
    }
  }

  @Test
  void mainLoopHasTimeToSpare() throws IOException {
    try (Chassis chassis = chassis()) {
      run(chassis, Twist.ZERO, SECOND);
      probe.truth(); // forgets how busy it was when it started
      for (int i = 0; i < 6 * SECOND; i++) {
        nanos += 13_000; // wherever the exchanges fall in the firmware's period
        run(chassis, new Twist(0.3 * Math.sin(i / 7.0), 0.2, 3 * Math.cos(i / 20.0)), 1);
      }
      long busiest = probe.truth().number("busiest_us");

      assertTrue(busiest > 1_000 && busiest <= build.busiestMicros(), busiest + " us");
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
        new SimulatorTransport(microcontroller.socket()),
        "r1 127.0.0.1",
        START,
        true,
        FirmwareSettings.DEFAULT,
        null,
        nanos);
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

  /** It may start in the middle of a frame. */
  private FirmwareStatus untilItHasStarted(SimulatorTransport spi) throws IOException {
    Optional<FirmwareStatus> status = Optional.empty();
    for (int i = 0; i < 50 && status.isEmpty(); i++) {
      status = exchange(spi, i);
    }
    return exchange(spi, 0).orElseThrow();
  }

  /** So many exchanges with the shortest pauses. Returns the last status; no answer is missing. */
  private FirmwareStatus exchangeAll(SimulatorTransport spi, int exchanges) throws IOException {
    FirmwareStatus status = exchange(spi, 0).orElseThrow();
    for (int i = 1; i < exchanges; i++) {
      status = exchange(spi, i % FrameCodec.SEQUENCES).orElseThrow();
    }
    return status;
  }

  private Optional<FirmwareStatus> exchange(SimulatorTransport spi, int sequence)
      throws IOException {
    nanos += 1_000_000; // less than it takes
    byte[] frame = FrameCodec.encode(new Velocity(Twist.ZERO), sequence);
    return FrameCodec.decode(spi.exchange(frame, nanos));
  }

  /** The same with any pause in front of it, in micros. */
  private Optional<FirmwareStatus> exchange(SocketChannel master, int sequence, int pause)
      throws IOException {
    ByteBuffer bytes =
        ByteBuffer.allocate(7 + FrameCodec.LENGTH)
            .order(ByteOrder.LITTLE_ENDIAN)
            .put((byte) 'X')
            .putInt(pause + build.exchangeMicros())
            .putShort((short) FrameCodec.LENGTH)
            .put(FrameCodec.encode(new Velocity(Twist.ZERO), sequence))
            .flip();
    while (bytes.hasRemaining()) {
      master.write(bytes);
    }
    ByteBuffer answer = ByteBuffer.allocate(FrameCodec.LENGTH);
    while (answer.hasRemaining() && master.read(answer) >= 0) {}
    return FrameCodec.decode(answer.array());
  }

  private void clear(Chassis chassis) {
    chassis.clearStops(run(chassis, Twist.ZERO, 10).stops());
    assertEquals(List.of(), codes(run(chassis, Twist.ZERO, 10)));
  }

  private static void assertInBudget(Truth truth, String interrupt, long budget) {
    long cycles = truth.number(interrupt);
    assertTrue(cycles > 0 && cycles <= budget, interrupt + " " + cycles);
  }

  private static List<String> codes(ChassisReading reading) {
    return reading.faults().stream().map(Fault::code).toList();
  }
}
