package org.toqa.agent.chassis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

class SimulatedChassisTest {

  private static final Pose START = new Pose(1, 2, 0.5);
  private static final long TICK = 20_000_000;
  private static final int SECOND = 50;

  @TempDir Path folder;
  private long nanos;

  @ParameterizedTest
  @CsvSource({"0.25, 0, 0", "0, 0.2, 0", "0, 0, 1.5", "0.2, -0.1, 0.7", "-0.3, 0, -1"})
  void bodyMovesAsItIsTold(double vx, double vy, double w) throws IOException {
    try (SimulatedChassis body = body(0)) {
      run(body, new Twist(vx, vy, w), 2 * SECOND);
      ChassisReading then = body.exchange(new Twist(vx, vy, w), nanos);
      ChassisReading now = run(body, new Twist(vx, vy, w), SECOND);

      Pose expected = then.odometry().advanced(new Twist(vx, vy, w), 1);
      assertEquals(0, expected.distanceTo(now.odometry()), 0.001);
      assertEquals(vx, now.twist().vx(), 0.001);
      assertEquals(vy, now.twist().vy(), 0.001);
      assertEquals(w, now.twist().w(), 0.001);
    }
  }

  @Test
  void odometryOfABodyThatDoesNotSlipIsTheTruthWithinItsEncoders() throws IOException {
    try (SimulatedChassis body = body(0)) {
      ChassisReading now = run(body, new Twist(0.25, 0.05, 0.6), 20 * SECOND);

      // 5 m with 0.09 mm a count
      assertEquals(0, START.compose(now.odometry()).distanceTo(body.truePose()), 0.005);
    }
  }

  @Test
  void slipTakesOdometryAwayFromTheTruthTheSameWayEveryTime() throws IOException {
    Pose first = truthAfterAMinute(folder.resolve("one"), 3);
    Pose again = truthAfterAMinute(folder.resolve("two"), 3);
    Pose other = truthAfterAMinute(folder.resolve("three"), 4);

    assertEquals(first, again);
    assertNotEquals(first, other);
  }

  @Test
  void speedRisesNoFasterThanTheMotorsCan() throws IOException {
    try (SimulatedChassis body = body(0)) {
      body.exchange(new Twist(0.5, 0, 0), nanos);
      double before = 0;
      for (int i = 0; i < SECOND; i++) {
        double now = run(body, new Twist(0.5, 0, 0), 1).twist().vx();
        // 1.5 m/s2 at the rim is 1.5 / (sqrt(3)/2) forward
        assertTrue(now - before <= 1.733 * 0.02, "from " + before + " to " + now);
        before = now;
      }
      assertEquals(0.5, before, 0.001);
    }
  }

  @Test
  void wheelsTurnNoFasterThanRated() throws IOException {
    try (SimulatedChassis body = body(0)) {
      ChassisReading now = run(body, new Twist(5, 0, 0), 5 * SECOND);

      // 220 turns a minute of a wheel of 0.04 m: 0.9215 m/s; forward by 2/sqrt(3) of it
      assertEquals(0.9215 * 2 / Math.sqrt(3), now.twist().vx(), 0.001);
      assertEquals(0, now.twist().w(), 0.001);
    }
  }

  @Test
  void oldCommandStopsTheWheels() throws IOException {
    try (SimulatedChassis body = body(0)) {
      Pose before = run(body, new Twist(0.25, 0, 0), 2 * SECOND).odometry();
      nanos += 60_000_000_000L;
      ChassisReading later = body.exchange(Twist.ZERO, nanos);

      // 0.2 s at 0.25 m/s, and the braking distance
      double rolled = before.distanceTo(later.odometry());
      assertTrue(rolled > 0.05 && rolled < 0.09, "rolled " + rolled);
      assertTrue(later.isStanding());
    }
  }

  @Test
  void bodyOfADaemonThatDiedIsFoundWhereItRolledOut() throws IOException {
    Pose before;
    try (SimulatedChassis body = body(0)) {
      before = run(body, new Twist(0.25, 0, 0), 2 * SECOND).odometry();
    }
    try (SimulatedChassis body = body(0)) {
      ChassisReading found = body.exchange(Twist.ZERO, 0);

      double rolled = before.distanceTo(found.odometry());
      assertTrue(rolled > 0.05 && rolled < 0.09, "rolled " + rolled);
      assertTrue(found.isStanding());
      assertEquals(1, found.powerCycle());
      assertEquals(0, START.compose(found.odometry()).distanceTo(body.truePose()), 0.001);
    }
  }

  @Test
  void powerCycleTakesTheKnowledgeOfThePlaceAndNotThePlace() throws IOException {
    try (SimulatedChassis body = body(0)) {
      ChassisReading before = run(body, new Twist(0.25, 0, 0), SECOND);
      Pose truth = body.truePose();
      body.cyclePower();
      ChassisReading after = body.exchange(Twist.ZERO, nanos);

      assertEquals(START, before.startPose());
      assertNull(after.startPose());
      assertNotEquals(before.powerCycle(), after.powerCycle());
      assertEquals(new Pose(0, 0, 0), after.odometry());
      assertEquals(truth, body.truePose());
    }
  }

  @Test
  void batteryLastsEightyMinutesOfDriving() throws IOException {
    try (SimulatedChassis body = body(0)) {
      double full = run(body, new Twist(0.25, 0, 0), SECOND).battery();
      double later = run(body, new Twist(0.25, 0, 0), 60 * SECOND).battery();

      assertEquals(1 / 80.0, full - later, 1e-4);
    }
  }

  @Test
  void aLoadDrainsTheBatteryMore() throws IOException {
    try (SimulatedChassis body = body(0)) {
      run(body, new Twist(0.25, 0, 0), SECOND);
      double before = body.exchange(new Twist(0.25, 0, 0), nanos).battery();
      double empty = before - run(body, new Twist(0.25, 0, 0), 60 * SECOND).battery();
      body.setLoad(5);
      double loaded = before - empty - run(body, new Twist(0.25, 0, 0), 60 * SECOND).battery();

      assertEquals(15 * 5 * 1.5 / 106_560.0, loaded - empty, 1e-5); // 15 m, 5 kg, 1.5 J/m/kg
    }
  }

  @Test
  void bodyOnTwoWheelsDrivesItsArcAndKnowsIt() {
    try (SimulatedChassis body =
        new SimulatedChassis(START, SimulatedWheels.differential(0, 0), 1)) {
      Twist arc = new Twist(0.2, 0, 0.4);
      run(body, arc, 2 * SECOND);
      ChassisReading then = body.exchange(arc, nanos);
      ChassisReading now = run(body, arc, 5 * SECOND);

      assertEquals(0, then.odometry().advanced(arc, 5).distanceTo(now.odometry()), 0.002);
      assertEquals(0, START.compose(now.odometry()).distanceTo(body.truePose()), 0.002);
    }
  }

  @Test
  void aBodyThatStandsAtAChargerIsCharged() throws IOException {
    SimulatedBattery power = new SimulatedBattery(0.5, List.of(START.position()));
    Path file = folder.resolve("docked");
    try (SimulatedChassis body = new SimulatedChassis(file, START, power, 0.01, 1)) {
      double after = run(body, Twist.ZERO, 60 * SECOND).battery();
      assertEquals(0.5 + 1 / 30.0, after, 1e-3); // a full battery in 30 minutes

      double gone = run(body, new Twist(0.25, 0, 0), 4 * SECOND).battery();
      assertTrue(run(body, Twist.ZERO, 60 * SECOND).battery() < gone, "a metre away");
    }
  }

  @Test
  void aBodyThatStandsDoesNotMoveAndItsTimeGoesOn() throws IOException {
    try (SimulatedChassis body = body(0.01);
        SimulatedBodyFile told = new SimulatedBodyFile(folder)) {
      run(body, new Twist(0.2, 0, 0.5), SECOND);
      run(body, Twist.ZERO, 2 * SECOND);
      SimulatedBodyFile.Reading then = told.read().orElseThrow();

      nanos += 66_666_666; // as a daemon at rest
      ChassisReading now = body.exchange(Twist.ZERO, nanos);
      assertEquals(Twist.ZERO, now.twist());
      assertEquals(then.steps() + 4, told.read().orElseThrow().steps()); // of 20 ms at most

      double later = run(body, Twist.ZERO, 30 * SECOND).battery();
      assertEquals(then.truePose(), body.truePose());
      assertEquals(then.steps() + 4 + 30 * SECOND, told.read().orElseThrow().steps());
      assertEquals(then.battery() - 30.067 / 28_800, later, 1e-6); // eight hours of standstill
    }
  }

  @Test
  void wheelsOfOtherSizesTakeOdometryAwayFromTheTruth() {
    try (SimulatedChassis body = new SimulatedChassis(START, SimulatedWheels.omni(0, 0.01), 2)) {
      ChassisReading now = run(body, new Twist(0.25, 0, 0), 40 * SECOND);

      // 10 m on wheels that are about 1 % too large or too small
      double away = START.compose(now.odometry()).distanceTo(body.truePose());
      assertTrue(away > 0.01 && away < 2, "away by " + away);
    }
  }

  @Test
  void frozenBodyStandsUntilItThaws() {
    try (SimulatedChassis body = new SimulatedChassis(START, SimulatedWheels.omni(0, 0), 1)) {
      Twist ahead = new Twist(0.25, 0, 0);
      run(body, ahead, SECOND);
      body.setFrozen(true);
      Pose frozen = run(body, ahead, 1).odometry();
      assertEquals(frozen, run(body, ahead, SECOND).odometry());

      body.setFrozen(false);
      assertTrue(frozen.distanceTo(run(body, ahead, SECOND).odometry()) > 0.1);
    }
  }

  @Test
  void lostFramesAreBorneUntilTheCommandRunsOut() {
    try (SimulatedChassis body = new SimulatedChassis(START, SimulatedWheels.omni(0, 0), 1)) {
      Twist ahead = new Twist(0.25, 0, 0);
      run(body, ahead, SECOND);
      body.loseFrames(5);
      assertEquals(0.25, run(body, ahead, 6).twist().vx(), 0.01);

      body.loseFrames(SECOND + 1);
      Pose before = body.truePose();
      Pose heard = run(body, ahead, SECOND).odometry();
      assertEquals(0.25 * 0.3, before.distanceTo(body.truePose()), 0.03); // 0.2 s, and the roll-out
      assertEquals(before.distanceTo(START), heard.x(), 0.02); // nothing new was heard
      assertEquals(0.25, run(body, ahead, SECOND).twist().vx(), 0.01);
    }
  }

  @Test
  void slippingWheelIsUnseenByTheEncoders() {
    try (SimulatedChassis body = new SimulatedChassis(START, SimulatedWheels.omni(0, 0), 1)) {
      body.setWheelSlip(0, 0.5);
      ChassisReading now = run(body, new Twist(0.25, 0, 0), 4 * SECOND);

      assertEquals(1, now.odometry().x(), 0.05);
      assertEquals(0, now.odometry().theta(), 0.01);
      assertTrue(START.compose(now.odometry()).distanceTo(body.truePose()) > 0.1);
    }
  }

  @Test
  void sensorsSeeWhatStandsRoundTheBodyAndABlindOneNothing() throws IOException {
    RangeSensors sensors = new RangeSensors(0.2);
    Path file = folder.resolve("seeing");
    try (SimulatedChassis body =
        new SimulatedChassis(file, START, SimulatedBattery.FULL, 0, 1, sensors, wall(0.5))) {
      body.setBlind(2, true);
      List<Double> ranges = body.exchange(Twist.ZERO, nanos).ranges();

      assertEquals(0.5, ranges.get(0), 0.015); // noise of 0.5 %
      assertEquals(0.5, ranges.get(1), 0.015);
      assertEquals(RangeSensors.FARTHEST, ranges.get(2));
    }
    try (SimulatedChassis body = body(0)) {
      List<Double> ranges = body.exchange(Twist.ZERO, nanos).ranges();
      assertEquals(Collections.nCopies(3, RangeSensors.FARTHEST), ranges);
    }
  }

  @Test
  void marksOnTheFloorTakeTheErrorOfOdometryAway() throws IOException {
    RangeSensors sensors = new RangeSensors(0.2);
    Path file = folder.resolve("marked");
    try (SimulatedChassis body =
        new SimulatedChassis(file, START, SimulatedBattery.FULL, 0.05, 3, sensors, wall(9))) {
      ChassisReading now = run(body, new Twist(0.2, 0, 0.1), 60 * SECOND);

      assertEquals(0, START.compose(now.odometry()).distanceTo(body.truePose()), 1e-9);
    }
  }

  /** A floor with marks everywhere, and in each direction a wall. */
  private static Surroundings wall(double metres) {
    return new Surroundings() {
      @Override
      public void setTruePose(Pose truth) {}

      @Override
      public double distance(Pose ray, double farthest) {
        return Math.min(metres, farthest);
      }

      @Override
      public boolean isMarked(Vec2 point) {
        return true;
      }
    };
  }

  private Pose truthAfterAMinute(Path file, long seed) throws IOException {
    try (SimulatedChassis body =
        new SimulatedChassis(file, START, SimulatedBattery.FULL, 0.05, seed)) {
      nanos = 0;
      ChassisReading now = run(body, new Twist(0.2, 0, 0.1), 60 * SECOND);
      assertNotEquals(0, START.compose(now.odometry()).distanceTo(body.truePose()), 0.001);
      return body.truePose();
    }
  }

  private SimulatedChassis body(double noise) throws IOException {
    return new SimulatedChassis(folder.resolve("body"), START, SimulatedBattery.FULL, noise, 1);
  }

  private ChassisReading run(SimulatedChassis body, Twist command, int ticks) {
    ChassisReading last = body.exchange(command, nanos);
    for (int i = 0; i < ticks; i++) {
      nanos += TICK;
      last = body.exchange(command, nanos);
    }
    return last;
  }
}
