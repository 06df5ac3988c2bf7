package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.agent.chassis.ArmDrive;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.firmware.ArmSettings.JointWiring;
import org.toqa.agent.firmware.SimulatorProbe.Truth;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmAction;
import org.toqa.arm.ArmControl;
import org.toqa.arm.ArmFailure;
import org.toqa.arm.ArmOutcome;
import org.toqa.arm.ArmReading;
import org.toqa.arm.ArmStep;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.sim.SimulatedMicrocontroller;

/**
 * The steps of an arm over the firmware in the simulated chip, whose servos turn a modelled arm.
 */
@Tag("full")
@Timeout(120)
class ArmIT {

  private static final long TICK = 20_000_000;
  private static final double TICK_SECONDS = TICK / 1e9;
  private static final int SECOND = 50;
  private static final double SPAN = Math.toRadians(320);

  /** Near enough by a potentiometer, of whose span a step of the converter is 1/1024. */
  private static final double ARRIVED = 0.01 + SPAN / 1024;

  private static final Arm ARM =
      new Arm(
          0.3,
          0.25,
          new Pose(0.05, 0, 0),
          new JointLimits(-SPAN / 2, SPAN / 2, Math.PI / 2, Math.PI),
          new JointLimits(-SPAN / 2, SPAN / 2, Math.PI / 2, Math.PI),
          2,
          new JointAngles(Math.toRadians(120), Math.toRadians(-150)));

  private static final JointAngles PLACE = new JointAngles(-0.4, 1.1);

  @TempDir Path folder;
  private long nanos;

  /** A daemon's view of one chip. */
  private final class Session implements AutoCloseable {
    final Chassis chassis;
    final ArmDrive drive;
    final ArmControl control;
    final SimulatorProbe probe;
    ChassisReading body;

    Session(SimulatedMicrocontroller chip, ArmSettings settings) throws IOException {
      probe = new SimulatorProbe(chip.socket());
      chassis =
          new FirmwareChassis(
              new SimulatorTransport(chip.socket()),
              "r1",
              null,
              true,
              FirmwareSettings.DEFAULT,
              settings,
              nanos);
      drive = chassis.arm().orElseThrow();
      control = new ArmControl(settings.arm(), drive.reading());
      body = chassis.exchange(MoveAt.STANDSTILL, nanos += TICK);
    }

    ArmReading tick(Twist twist) {
      body = chassis.exchange(twist, nanos += TICK);
      return drive.exchange(
          control.advance(TICK_SECONDS, drive.reading(), body.stops().isEmpty()), nanos);
    }

    void run(int ticks) {
      for (int i = 0; i < ticks; i++) {
        tick(Twist.ZERO);
      }
    }

    ArmOutcome runToItsEnd() {
      for (int i = 0; i < 30 * SECOND; i++) {
        tick(Twist.ZERO);
        var outcome = control.takeOutcome();
        if (outcome.isPresent()) {
          return outcome.get();
        }
      }
      throw new AssertionError("it does not end: " + control.step() + " " + drive.reading());
    }

    void runUntil(ArmStep step) {
      for (int i = 0; i < 30 * SECOND; i++) {
        if (control.step().filter(step::equals).isPresent()) {
          return;
        }
        tick(Twist.ZERO);
      }
      throw new AssertionError("it does not come to " + step);
    }

    /** Where a joint truly is, 0 the shoulder. */
    double truth(int joint) throws IOException {
      return -SPAN / 2 + SPAN * probe.truth().decimal("servo" + (joint + 1));
    }

    @Override
    public void close() throws IOException {
      probe.close();
      chassis.close();
    }
  }

  private Session session(SimulatedMicrocontroller chip) throws IOException {
    return new Session(chip, ArmSettings.of(ARM));
  }

  @ParameterizedTest
  @EnumSource
  void picksUpWeighsAndPlaces(FirmwareBuild build) throws IOException {
    try (SimulatedMicrocontroller chip = build.start(folder);
        Session session = session(chip)) {
      session.run(SECOND);
      assertEquals(ARM.rest().shoulder(), session.truth(0), 0.01); // where the model begins
      Truth started = session.probe.truth(); // bytes that came before are nobody's
      session.drive.expectLoad(1.4);
      session.control.begin(ArmAction.PICK, PLACE, false);
      session.runUntil(ArmStep.GRASP);
      assertEquals(PLACE.shoulder(), session.truth(0), ARRIVED);
      assertEquals(PLACE.elbow(), session.truth(1), ARRIVED);
      ArmOutcome picked = session.runToItsEnd();
      assertEquals(null, picked.failure());
      assertEquals(1.4, picked.weight(), 0.01);
      assertTrue(session.control.isFolded());
      assertTrue(session.drive.reading().isHolding());

      session.control.begin(ArmAction.PLACE, new JointAngles(1, -2), false);
      assertEquals(new ArmOutcome(null, null), session.runToItsEnd());
      assertEquals(1, session.probe.truth().number("grasps"));
      assertEquals(1, session.probe.truth().number("releases"));
      // the multiplexer was never switched during a pulse, and no byte found the last one unread
      assertEquals(0, session.probe.truth().number("cut_pulses"));
      assertEquals(started.number("overruns"), session.probe.truth().number("overruns"));
      assertEquals(started.number("late_answers"), session.probe.truth().number("late_answers"));
      assertTrue(session.probe.truth().number("busiest_us") < build.busiestMicros());
      assertEquals(List.of(), session.body.faults());
    }
  }

  /** Both joints begin and end together, within their limits, as the servos are told. */
  @Test
  void jointsStayOnTheLineAndWithinTheirRates() throws IOException {
    try (SimulatedMicrocontroller chip = FirmwareBuild.PWM_AT_8_MHZ.start(folder);
        Session session = session(chip)) {
      session.run(SECOND / 2);
      session.control.begin(ArmAction.PICK, PLACE, false);
      List<Double> shoulder = new ArrayList<>();
      while (session.control.step().orElseThrow() == ArmStep.REACH) {
        session.tick(Twist.ZERO);
        double at = session.truth(0);
        double share = (at - ARM.rest().shoulder()) / (PLACE.shoulder() - ARM.rest().shoulder());
        double other = ARM.rest().elbow() + share * (PLACE.elbow() - ARM.rest().elbow());
        assertEquals(other, session.truth(1), 0.05); // servos are told one after the other
        shoulder.add(at);
      }
      for (int i = 5; i < shoulder.size(); i++) {
        double rate = Math.abs(shoulder.get(i) - shoulder.get(i - 5)) / (5 * TICK_SECONDS);
        assertTrue(rate <= ARM.shoulder().maxRate() * 1.25, "" + rate);
      }
    }
  }

  @Test
  void pressedSwitchStopsTheArmAtOnceAndItGoesOnWhenAPersonSaysSo() throws IOException {
    try (SimulatedMicrocontroller chip = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
        Session session = session(chip)) {
      session.run(SECOND / 2);
      session.control.begin(ArmAction.PICK, PLACE, false);
      session.run(SECOND);
      session.probe.change("switch pressed");
      session.probe.advance(Duration.ofMillis(40)); // a servo's period is 20 ms
      double stopped = session.truth(0);
      session.probe.advance(Duration.ofMillis(100));
      assertEquals(stopped, session.truth(0), 0.002);
      session.run(2 * SECOND);
      assertEquals(stopped, session.truth(0), 0.002);
      assertTrue(session.control.takeOutcome().isEmpty());

      session.probe.change("switch released");
      session.run(5);
      session.chassis.clearStops(Set.of("STOP_SWITCH"));
      assertEquals(null, session.runToItsEnd().failure());
    }
  }

  @Test
  void armOfADaemonThatIsSilentStandsAndHoldsWhatItHas() throws IOException {
    try (SimulatedMicrocontroller chip = FirmwareBuild.LM629_AT_16_MHZ.start(folder)) {
      double stood;
      try (Session session = session(chip)) {
        session.run(SECOND / 2);
        session.control.begin(ArmAction.PICK, PLACE, false);
        session.runUntil(ArmStep.FOLD);
        session.run(SECOND / 2);
        session.probe.advance(Duration.ofMillis(300));
        stood = session.truth(0);
        session.probe.advance(Duration.ofSeconds(2));
        assertEquals(stood, session.truth(0), 1e-6);
      }
      try (Session anew = session(chip)) { // whose daemon was started anew
        assertTrue(anew.drive.reading().isHolding());
        assertEquals(stood, anew.drive.reading().angles().shoulder(), 0.01);
        anew.control.begin(ArmAction.PICK, PLACE, true);
        assertEquals(null, anew.runToItsEnd().failure());
        assertEquals(1, anew.probe.truth().number("grasps")); // not twice
      }
    }
  }

  @Test
  void chipThatStartsAnewDropsNothing() throws IOException {
    try (SimulatedMicrocontroller chip = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
        Session session = session(chip)) {
      session.run(SECOND / 2);
      session.control.begin(ArmAction.PICK, PLACE, false);
      session.runToItsEnd();
      session.probe.change("program hung");
      session.run(2 * SECOND);
      assertEquals(
          List.of("STOP_WATCHDOG"), session.body.faults().stream().map(Fault::code).toList());
      assertTrue(session.drive.reading().isHolding());
      assertEquals(0, session.probe.truth().number("releases"));
    }
  }

  @Test
  void stuckJointAndEmptyHandAreTold() throws IOException {
    try (SimulatedMicrocontroller chip = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
        Session session = session(chip)) {
      session.run(SECOND / 2);
      session.probe.change("box 0");
      session.control.begin(ArmAction.PICK, PLACE, false);
      assertEquals(ArmFailure.NOTHING_GRASPED, session.runToItsEnd().failure());
      session.probe.change("arm stuck");
      session.control.begin(ArmAction.PICK, PLACE, false);
      assertEquals(ArmFailure.STALLED, session.runToItsEnd().failure());
      session.probe.change("arm free");
      session.probe.change("box 2500");
      session.control.begin(ArmAction.PICK, PLACE, false);
      assertEquals(ArmFailure.TOO_HEAVY, session.runToItsEnd().failure());
    }
  }

  /** A person may be in its way: it does not push again and again. */
  @Test
  void armThatIsKeptFromItsRestStandsUntilAPersonSaysSo() throws IOException {
    try (SimulatedMicrocontroller chip = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
        Session session = session(chip)) {
      session.run(SECOND / 2);
      session.control.begin(ArmAction.PICK, PLACE, false);
      session.run(SECOND);
      session.control.cancel();
      session.run(SECOND);
      session.probe.change("arm stuck");
      for (int i = 0; i < 5 * SECOND; i++) {
        session.control.fold();
        session.tick(Twist.ZERO);
      }
      assertTrue(session.control.hasFailedToFold());
      assertFalse(session.drive.reading().stalled());
      session.probe.change("arm free");
      double stood = session.truth(0);
      for (int i = 0; i < 5 * SECOND; i++) {
        session.control.fold();
        session.tick(Twist.ZERO);
        assertEquals(stood, session.truth(0), 0.03);
      }
      session.control.cancel();
      for (int i = 0; i < 5 * SECOND; i++) {
        session.control.fold();
        session.tick(Twist.ZERO);
      }
      assertTrue(session.control.isFolded());
      assertFalse(session.control.hasFailedToFold());
    }
  }

  /** An elbow that is wired the other way round, and a robot that drives with its arm at rest. */
  @Test
  void measuresComeByConfigurationAndAreKept() throws IOException {
    JointWiring turned = new JointWiring(2_500, 500, 4.5, 0.5);
    ArmSettings settings = new ArmSettings(ARM, JointWiring.DEFAULT, turned, 1_000, 2_000, 0.5, 1);
    SimulatedMicrocontroller first = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
    try (first;
        Session session = new Session(first, settings)) {
      session.run(SECOND);
      session.control.begin(ArmAction.PICK, new JointAngles(0.5, 1), false);
      session.runUntil(ArmStep.GRASP);
      assertEquals(-1, session.truth(1), ARRIVED);
      session.runToItsEnd();
      double before = session.body.odometry().x();
      for (int i = 0; i < 2 * SECOND; i++) {
        session.tick(new Twist(0.25, 0, 0));
      }
      assertEquals(0.5, session.body.odometry().x() - before, 0.05);
      assertFalse(session.body.isStanding());
      assertTrue(session.drive.reading().isHolding());
    }
    try (SimulatedMicrocontroller again = FirmwareBuild.LM629_AT_16_MHZ.start(folder);
        SimulatorProbe probe = new SimulatorProbe(again.socket())) {
      probe.advance(Duration.ofMillis(100));
      byte[] answer = poll(again);
      ArmStatus status = FrameCodec.decodeArm(answer).orElseThrow();
      assertEquals(ArmStatus.State.STANDING, status.state()); // it knows its arm by its EEPROM
      assertEquals(-SPAN / 2 + SPAN * 0.875, status.angles().shoulder(), 0.01);
    }
  }

  private byte[] poll(SimulatedMicrocontroller chip) throws IOException {
    try (SimulatorTransport spi = new SimulatorTransport(chip.socket())) {
      byte[] frame = FrameCodec.encode(new FirmwareCommand.ArmPoll(), 1);
      spi.exchange(frame, nanos += TICK);
      return spi.exchange(frame, nanos += TICK);
    }
  }
}
