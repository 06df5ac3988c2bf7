package org.toqa.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/** An arm whose joints are where they were told a tick before. */
class ArmControlTest {
  private static final double TICK = 0.02;
  private static final Arm ARM =
      new Arm(
          0.3,
          0.25,
          new Pose(0.05, 0, 0),
          new JointLimits(-2.5, 2.5, 1.5, 4),
          new JointLimits(-2.8, 2.8, 2, 5),
          3,
          new JointAngles(2.2, -2.7));

  private ArmReading reading = new ArmReading(ARM.rest(), false, 0);
  private final ArmControl control = new ArmControl(ARM, reading);
  private double boxWeight = 1.25;
  private boolean isStuck;
  private boolean mayMove = true;
  private final List<JointAngles> rates = new ArrayList<>();

  private void tick() {
    ArmCommand command = control.advance(TICK, reading, mayMove);
    rates.add(command.rates());
    reading =
        new ArmReading(
            isStuck ? reading.angles() : command.angles(),
            command.handClosed(),
            command.handClosed() ? boxWeight : 0);
  }

  private ArmOutcome runToItsEnd() {
    for (int i = 0; i < 2_000; i++) {
      tick();
      Optional<ArmOutcome> outcome = control.takeOutcome();
      if (outcome.isPresent()) {
        return outcome.get();
      }
    }
    throw new AssertionError("it does not end: " + control.step());
  }

  private static JointAngles way(Vec2 target) {
    return assertInstanceOf(Reach.Within.class, InverseKinematics.solve(ARM, target))
        .ways()
        .getFirst();
  }

  private void begin(ArmAction action) {
    control.begin(action, way(new Vec2(0.4, 0.1)), false);
  }

  @Test
  void picksUpWeighsAndPlaces() {
    begin(ArmAction.PICK);
    assertEquals(new ArmOutcome(null, 1.25), runToItsEnd());
    assertTrue(control.isFolded());
    assertTrue(reading.isHolding());
    begin(ArmAction.PLACE);
    assertEquals(new ArmOutcome(null, null), runToItsEnd());
    assertTrue(control.isFolded());
    assertFalse(reading.isHolding());
  }

  @Test
  void handIsWhereTheLoadIsWhenItCloses() {
    begin(ArmAction.PICK);
    while (control.step().orElseThrow() == ArmStep.REACH) {
      tick();
    }
    assertEquals(0, ARM.handAt(reading.angles()).distanceTo(new Vec2(0.4, 0.1)), 0.006);
  }

  @Test
  void whatIsTooHeavyIsLetGoAndItsWeightTold() {
    boxWeight = 3.5;
    begin(ArmAction.PICK);
    assertEquals(new ArmOutcome(ArmFailure.TOO_HEAVY, 3.5), runToItsEnd());
    assertFalse(reading.handClosed());
    assertTrue(control.isFolded());
  }

  @Test
  void handThatGraspsNothingSaysSo() {
    boxWeight = 0;
    begin(ArmAction.PICK);
    assertEquals(new ArmOutcome(ArmFailure.NOTHING_GRASPED, null), runToItsEnd());
    begin(ArmAction.PLACE);
    assertEquals(new ArmOutcome(ArmFailure.NOTHING_HELD, null), runToItsEnd());
  }

  @Test
  void fullHandPicksUpNothingMore() {
    begin(ArmAction.PICK);
    runToItsEnd();
    begin(ArmAction.PICK);
    assertEquals(new ArmOutcome(ArmFailure.HAND_FULL, null), runToItsEnd());
  }

  @Test
  void loadThatHangsOnTheOpenHandIsTold() {
    begin(ArmAction.PICK);
    runToItsEnd();
    begin(ArmAction.PLACE);
    while (control.step().orElse(ArmStep.REACH) != ArmStep.FOLD) {
      tick();
      reading = new ArmReading(reading.angles(), reading.handClosed(), 1.25);
    }
    assertEquals(ArmFailure.NOT_RELEASED, runToItsEnd().failure());
  }

  @Test
  void jointsThatDoNotFollowAreNoticed() {
    begin(ArmAction.PICK);
    for (int i = 0; i < 20; i++) {
      tick();
    }
    isStuck = true;
    assertEquals(ArmFailure.STALLED, runToItsEnd().failure());
    assertTrue(control.step().isEmpty());
  }

  private void foldFor(double seconds) {
    for (int i = 0; i < seconds / TICK; i++) {
      control.fold();
      tick();
    }
  }

  /** It does not push again and again: somebody may be there. */
  @Test
  void armThatIsKeptFromItsRestStandsUntilItIsCancelled() {
    begin(ArmAction.PICK);
    for (int i = 0; i < 40; i++) {
      tick();
    }
    control.cancel();
    isStuck = true;
    JointAngles held = reading.angles();
    foldFor(8);
    assertTrue(control.hasFailedToFold());
    for (int i = 0; i < 500; i++) {
      control.fold();
      assertEquals(held, control.advance(TICK, reading, mayMove).goal());
    }
    isStuck = false;
    control.cancel();
    assertFalse(control.hasFailedToFold());
    foldFor(8);
    assertTrue(control.isFolded());
    assertFalse(control.hasFailedToFold());
  }

  /** By how much servo and potentiometer may differ without being told is 0.03. */
  @Test
  void armThatIsMeasuredALittleOffItsRestIsThere() {
    for (double off : new double[] {0.02, 0.04, 0.06, 0.3}) {
      reading = new ArmReading(ARM.rest().plus(new JointAngles(off, 0)), false, 0);
      ArmControl anew = new ArmControl(ARM, reading);
      for (int i = 0; i < 300; i++) {
        anew.fold();
        anew.advance(TICK, reading, true);
      }
      assertEquals(off < ArmControl.REST_TOLERANCE, anew.isFolded());
      assertEquals(off > ArmControl.REST_TOLERANCE, anew.hasFailedToFold());
    }
  }

  @Test
  void armThatIsPushedAsideAtItsRestGivesWayAndActsAfterwards() {
    JointAngles pushed = ARM.rest().plus(new JointAngles(-0.5, 0));
    reading = new ArmReading(pushed, false, 0, true);
    assertEquals(pushed, control.advance(TICK, reading, true).goal());
    reading = new ArmReading(pushed, false, 0);
    tick();
    assertFalse(control.hasFailedToFold());
    begin(ArmAction.PICK);
    assertEquals(new ArmOutcome(null, 1.25), runToItsEnd());
  }

  /** A hold stands within the time that the joints need, and the action goes on where it was. */
  @Property(tries = 60)
  void holdStopsItAtOnceAndItGoesOnFromThere(
      @ForAll @IntRange(min = 1, max = 250) int before,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 3) double held) {
    ArmControlTest run = new ArmControlTest();
    run.begin(ArmAction.PICK);
    for (int i = 0; i < before && run.control.step().isPresent(); i++) {
      run.tick();
    }
    Optional<ArmStep> step = run.control.step();
    run.mayMove = false;
    run.rates.clear();
    // 2 rad/s at 4 rad/s2: it stands after 0.5 s, and one tick
    for (int i = 0; i < 26; i++) {
      run.tick();
    }
    assertEquals(JointAngles.ZERO, run.rates.getLast());
    JointAngles stand = run.reading.angles();
    boolean isClosed = run.reading.handClosed();
    for (int i = 0; i < held / TICK; i++) {
      run.tick();
    }
    assertEquals(stand, run.reading.angles());
    assertEquals(isClosed, run.reading.handClosed());
    assertEquals(step, run.control.step());
    run.mayMove = true;
    if (step.isPresent()) {
      assertEquals(new ArmOutcome(null, 1.25), run.runToItsEnd());
    }
  }

  @Test
  void cancelledArmStandsAndIsFoldedWhenItIsTold() {
    begin(ArmAction.PICK);
    for (int i = 0; i < 30; i++) {
      tick();
    }
    control.cancel();
    for (int i = 0; i < 100; i++) {
      tick();
    }
    assertTrue(control.takeOutcome().isEmpty());
    assertTrue(control.isStanding());
    assertFalse(control.isFolded());
    control.fold();
    for (int i = 0; i < 200; i++) {
      tick();
    }
    assertTrue(control.isFolded());
  }

  @Test
  void actionBegunAnewWithTheLoadInHandWeighsItAndFolds() {
    begin(ArmAction.PICK);
    while (control.step().orElseThrow() != ArmStep.WEIGH) {
      tick();
    }
    ArmControlTest anew = new ArmControlTest();
    anew.reading = new ArmReading(reading.angles(), true, 1.25);
    ArmControl after = new ArmControl(ARM, anew.reading);
    after.begin(ArmAction.PICK, way(new Vec2(0.4, 0.1)), true);
    assertEquals(Optional.of(ArmStep.WEIGH), after.step());
  }
}
