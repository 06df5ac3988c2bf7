package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.PathProgress;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.firmware.SimulatorProbe.Truth;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.sim.SimulatedMicrocontroller;

/** Segments that the firmware drives by itself, in the simulated microcontroller. */
@Tag("full")
@Timeout(120)
@ParameterizedClass
@EnumSource
class DrivenPathIT {

  private static final Pose ORIGIN = new Pose(0, 0, 0);
  private static final long TICK = 20_000_000;
  private static final PaceLimits LIMITS =
      PaceLimits.forSingleRobot(new MotionLimits(0.5, 3.5, 0.5, 3));

  private final FirmwareBuild build;
  private final List<Segment> segments = new ArrayList<>();
  private final Random random = new Random(4);
  @TempDir Path folder;

  @SuppressWarnings("NullAway.Init") // by start
  private SimulatedMicrocontroller microcontroller;

  @SuppressWarnings("NullAway.Init")
  private SimulatorProbe probe;

  private long nanos;
  private Pose odometry = ORIGIN;
  private @Nullable PathProgress progress;

  DrivenPathIT(FirmwareBuild build) {
    this.build = build;
  }

  @BeforeEach
  void start() throws IOException {
    microcontroller = build.start(folder);
    probe = new SimulatorProbe(microcontroller.socket());
    for (int i = 0; i < 40; i++) {
      segments.add(new Segment(0.25, i % 8 < 4 ? 0.4 : -0.4, 0.09));
    }
  }

  @AfterEach
  void end() throws IOException {
    probe.close();
    microcontroller.close();
  }

  /** Of five frames one is damaged, the answer to one is lost, and one comes twice. */
  @Test
  void eachSegmentIsDrivenOnceOverABadLink() throws IOException {
    try (Chassis chassis = chassis(new BadLink(new SimulatorTransport(microcontroller.socket())))) {
      PathProgress end = driveToTheEnd(chassis, 1);

      assertEquals(40, end.completed());
      assertEnd(ORIGIN);
    }
  }

  /** And the main loop is not late: it would miss its period of 10 ms. */
  @Test
  void segmentsThatComeWhileItDrivesKeepTheSpeedUp() throws IOException {
    try (Chassis chassis = chassis(new SimulatorTransport(microcontroller.socket()))) {
      probe.truth(); // forgets how busy it was when it started
      long before = nanos;
      driveToTheEnd(chassis, 1);
      long busiest = probe.truth().number("busiest_us");

      assertEnd(ORIGIN);
      // 3.6 s as planned, 0.5 s to speed up and as much to slow down, each at half the speed
      assertEquals(3.6 + 0.5, (nanos - before) / 1e9, 0.6);
      assertTrue(busiest > 1_000 && busiest <= build.busiestMicros(), busiest + " us");
    }
  }

  @Test
  void pathIsStoppedByTheCutLinkAndNotBegunOnceMore() throws IOException {
    try (Chassis chassis = chassis(new SimulatorTransport(microcontroller.socket()))) {
      PathProgress before = drive(chassis, 1, true, 80);
      assertTrue(before.completed() > 5, before.toString());
      probe.advance(Duration.ofSeconds(1));
      Truth stopped = probe.truth();
      assertTrue(stopped.rolledOn().toMillis() <= 250, stopped.toString());
      assertEquals("STOPPED: LINK       ", stopped.text("lcd2"));

      nanos += 1_000_000_000;
      ChassisReading after = chassis.exchange(order(1, before, true), nanos);
      for (int i = 0; i < 100; i++) {
        after = chassis.exchange(order(1, before, true), nanos += TICK);
      }
      assertNull(after.progress());
      assertEquals(List.of(), after.faults());
      assertEquals(stopped.decimal("x"), probe.truth().decimal("x"), 0.001);

      Pose here = after.odometry();
      odometry = here;
      PathProgress again = driveToTheEnd(chassis, 2);
      assertEquals(40, again.completed());
      assertEnd(here);
    }
  }

  @Test
  void heldPathStandsAndGoesOn() throws IOException {
    try (Chassis chassis = chassis(new SimulatorTransport(microcontroller.socket()))) {
      drive(chassis, 1, true, 80);
      PathProgress held = drive(chassis, 1, false, 60);
      assertTrue(held.settled() && held.completed() < 40, held.toString());
      assertEquals(0, held.pace());
      driveToTheEnd(chassis, 1);
      assertEnd(ORIGIN);
    }
  }

  private Chassis chassis(FrameTransport transport) throws IOException {
    Chassis chassis =
        new FirmwareChassis(transport, "r1", null, true, FirmwareSettings.DEFAULT, null, nanos);
    for (int i = 0; i < 20; i++) {
      chassis.exchange(ChassisCommand.MoveAt.STANDSTILL, nanos += TICK);
    }
    return chassis;
  }

  private PathProgress driveToTheEnd(Chassis chassis, long number) {
    PathProgress last = drive(chassis, number, true, 5);
    for (int i = 0; i < 100 && !(last.settled() && last.completed() == segments.size()); i++) {
      last = drive(chassis, number, true, 5);
    }
    return last;
  }

  private PathProgress drive(Chassis chassis, long number, boolean onward, int ticks) {
    @Nullable PathProgress last = progress;
    for (int i = 0; i < ticks; i++) {
      nanos += TICK + 13_000; // wherever the exchanges fall in the firmware's period
      ChassisReading reading = chassis.exchange(order(number, last, onward), nanos);
      if (reading.progress() != null) {
        last = reading.progress();
      }
    }
    progress = last;
    return Objects.requireNonNull(last, "it has not begun");
  }

  private DrivePath order(long number, @Nullable PathProgress known, boolean onward) {
    int from = known == null || known.path() != number ? 0 : known.completed();
    int to = Math.min(segments.size(), from + Chassis.QUEUE_LENGTH);
    return new DrivePath(number, odometry, 0, LIMITS, from, segments.subList(from, to), onward);
  }

  private void assertEnd(Pose start) throws IOException {
    Pose planned = new Trajectory(start, segments).end();
    Truth truth = probe.truth();
    Pose really = new Pose(truth.decimal("x"), truth.decimal("y"), truth.decimal("theta"));
    assertEquals(0, planned.distanceTo(really), 0.005, planned + " " + really);
    assertEquals(planned.theta(), really.theta(), 0.01);
  }

  /** Damages, loses and repeats frames. */
  private final class BadLink implements FrameTransport {
    private final FrameTransport link;

    BadLink(FrameTransport link) {
      this.link = link;
    }

    @Override
    public byte[] exchange(byte[] frame, long now) throws IOException {
      byte[] sent = frame.clone();
      int what = random.nextInt(5);
      if (what == 0) {
        sent[random.nextInt(sent.length)] ^= 0x10;
      }
      byte[] answer = link.exchange(sent, now);
      if (what == 1) {
        return new byte[0];
      }
      return what == 2 ? link.exchange(sent, now + 8_000_000) : answer;
    }

    @Override
    public void close() {
      link.close();
    }
  }
}
