package org.toqa.fleet.history;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Readings;
import org.toqa.fleet.RobotView.Telemetry;
import org.toqa.fleet.RobotView.Work;
import org.toqa.geometry.Pose;
import org.toqa.mission.Phase;
import org.toqa.motion.DriveKind;
import org.toqa.motion.DriveSpeeds;
import org.toqa.testbed.Hall;
import org.toqa.wording.Sentence;

class UtilisationMeterTest {
  private static final Instant START = Instant.parse("2026-11-21T08:00:00Z");

  /** Metres a second. */
  private static final double SPEED = 0.5;

  private Instant now = START;
  private final UtilisationMeter meter =
      new UtilisationMeter(robot(RobotState.IDLE, 0, 0, 1), START, 1);

  @Test
  void timeGoesToWhatTheRobotDidUntilTheNextLook() {
    look(3, robot(RobotState.DRIVING, 1, 0, 1)); // 3 s idle
    look(4, robot(RobotState.HOLDING, 2, 0, 1)); // 4 s at work
    look(5, robot(RobotState.CHARGING, 0, 0, 1)); // 5 s at work
    look(6, robot(RobotState.CHARGING, 0, 0, 1)); // 6 s charging

    assertEquals(
        Map.of(
            RobotActivity.IDLE, Duration.ofSeconds(3),
            RobotActivity.WORKING, Duration.ofSeconds(9),
            RobotActivity.CHARGING, Duration.ofSeconds(6)),
        meter.record().time());
  }

  @ParameterizedTest
  @CsvSource({
    "IDLE, 0, false, IDLE",
    "IDLE, 0, true, HELD",
    "DRIVING, 0, false, TRAVELLING",
    "DRIVING, 1, false, WORKING",
    "IDLE, 2, false, WORKING",
    "HOLDING, 2, true, HELD",
    "DRIVING, 3, false, TRAVELLING",
    "CHARGING, 0, true, CHARGING",
    "ERROR, 2, false, TROUBLED",
    "NOT_LOCALISED, 0, false, TROUBLED",
    "LOST, 2, false, LOST",
    "CONNECTING, 0, false, LOST",
    "OUT_OF_SERVICE, 0, true, OUT_OF_SERVICE"
  })
  void whatARobotDoes(RobotState state, int phase, boolean held, RobotActivity use) {
    assertEquals(use, RobotActivity.of(robot(state, phase, 0, 1, held, START)));
  }

  @Test
  void whatTheServerDidNotSeeIsNotRecorded() {
    look(2, robot(RobotState.IDLE, 0, 0, 1));
    look(600, robot(RobotState.IDLE, 0, 0, 1));
    look(-60, robot(RobotState.IDLE, 0, 0, 1)); // somebody sets the clock

    assertEquals(Map.of(RobotActivity.IDLE, Duration.ofSeconds(2)), meter.record().time());
  }

  @Test
  void halfHoursAreRecordsOfTheirOwn() {
    Optional<UtilisationRecord> over = Optional.empty();
    while (over.isEmpty()) {
      over = look(10, robot(RobotState.IDLE, 0, 0, 1));
    }

    assertEquals(START.plus(Duration.ofMinutes(30)), now);
    assertEquals(START, over.get().at());
    assertEquals(Duration.ofMinutes(30), over.get().time().get(RobotActivity.IDLE));
    assertEquals(now, meter.record().at());
    assertEquals(Map.of(), meter.record().time());
  }

  @Test
  void theDistanceIsWhatItDroveAndNotHowItShivers() {
    for (int i = 1; i <= 20; i++) {
      look(1, robot(RobotState.DRIVING, 1, 0.4 * i, 1)); // 20 s at 0.4 m/s = 8 m
    }
    for (int i = 0; i < 100; i++) {
      look(1, robot(RobotState.IDLE, 0, 8 + 0.01 * (i % 3), 1));
    }

    assertEquals(8, meter.record().metres(), 0.05);
  }

  @Test
  void aSimulatedRobotMayGoFasterThanTheClock() {
    UtilisationMeter fast = new UtilisationMeter(robot(RobotState.DRIVING, 1, 0, 1), START, 10);

    for (int i = 1; i <= 3; i++) {
      Instant at = START.plusSeconds(i);
      assertTrue(fast.observe(robot(RobotState.DRIVING, 1, 5.0 * i, 1, false, at), at).isEmpty());
    }

    assertEquals(15, fast.record().metres(), 1e-9); // 3 s at 10 times 0.5 m/s
  }

  @Test
  void aPersonWhoSaysWhereItStandsDrivesItNowhere() {
    look(1, robot(RobotState.IDLE, 0, 0.2, 1));
    look(1, robot(RobotState.IDLE, 0, 30, 1));
    look(1, robot(RobotState.DRIVING, 1, 30.4, 1));

    assertEquals(0.6, meter.record().metres(), 1e-9); // 0.2 + 0.4
  }

  @Test
  void chargingGivesNothingBack() {
    for (double battery : List.of(0.9, 0.8, 0.802, 0.798, 0.95, 0.9)) {
      look(1, robot(RobotState.IDLE, 0, 0, battery));
    }

    assertEquals(0.25, meter.record().battery(), 1e-9); // 0.1 + 0.1 + 0.05; 0.002 may be an error
  }

  private Optional<UtilisationRecord> look(long secondsLater, RobotView view) {
    now = now.plusSeconds(secondsLater);
    return meter.observe(seenAt(now, view), now);
  }

  private static RobotView robot(RobotState state, int phase, double x, double battery) {
    return robot(state, phase, x, battery, false, START);
  }

  private static RobotView seenAt(Instant at, RobotView view) {
    Telemetry seen = view.telemetry();
    return view.withTelemetry(
        new Telemetry(seen.pose(), seen.battery(), seen.readings(), seen.errors(), at));
  }

  private static RobotView robot(
      RobotState state, int phase, double x, double battery, boolean held, Instant seen) {
    Long task = phase == 0 ? null : 7L;
    return Hall.robot("r1", state, null, "127.0.0.1", 7275)
        .withCapabilities(
            new RobotCapabilities(
                0.3, new DriveSpeeds(SPEED, 1, 1), Double.MAX_VALUE, 0.8, DriveKind.OMNI))
        .withWork(new Work(task, Phase.stored(phase), held, null, Sentence.verbatim("")))
        .withTelemetry(new Telemetry(new Pose(x, 0, 0), battery, Readings.NONE, List.of(), seen));
  }
}
