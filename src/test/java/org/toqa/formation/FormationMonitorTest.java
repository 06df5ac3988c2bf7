package org.toqa.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.formation.Verdict.Drive;
import org.toqa.formation.Verdict.Reason;
import org.toqa.formation.Verdict.Stop;

class FormationMonitorTest {

  private final FormationMonitor watch = new FormationMonitor(List.of("r2", "r3"), 0.05);

  @Test
  void groupStandsUntilEachFollowerHasAnswered() {
    watch.recordAnswer("r2", 0, true, 1);
    assertEquals(new Stop(Reason.NOT_READY, "r3"), watch.verdict(1));

    watch.recordAnswer("r3", 0, true, 1);
    assertEquals(new Drive(1), watch.verdict(1));
  }

  @Test
  void strainSlowsTheLeader() {
    watch.recordAnswer("r2", 0, true, 1);
    watch.recordAnswer("r3", 0.0375, true, 1);

    // three quarters of the tolerance: half way between slowing and stopping
    assertEquals(0.5, assertInstanceOf(Drive.class, watch.verdict(1)).pace(), 1e-9);
  }

  @Test
  void followerOutOfPlaceStopsTheGroupUntilItIsNearItsPlaceAgain() {
    bothWell(1);
    watch.recordAnswer("r3", 0.051, true, 1.2);
    assertEquals(new Stop(Reason.OUT_OF_PLACE, "r3"), watch.verdict(1.2));

    bothAnswer(0.03, 1.4);
    assertEquals(new Stop(Reason.OUT_OF_PLACE, "r3"), watch.verdict(1.4));

    bothAnswer(0.02, 1.6);
    assertInstanceOf(Drive.class, watch.verdict(1.6));
  }

  @Test
  void followerThatMissesTwoAnswersStopsTheGroupUntilItAnswersAgain() {
    bothWell(1);
    watch.recordAnswer("r2", 0, true, 1.4);
    assertEquals(new Drive(1), watch.verdict(1.42));
    assertEquals(new Stop(Reason.LATE, "r3"), watch.verdict(1.46));

    watch.recordAnswer("r3", 0, true, 1.5);
    assertEquals(new Drive(1), watch.verdict(1.5));
  }

  @Test
  void followerThatDoesNotFollowStopsTheGroup() {
    bothWell(1);
    watch.recordAnswer("r2", 0, false, 1.2);

    assertEquals(new Stop(Reason.NOT_FOLLOWING, "r2"), watch.verdict(1.2));
  }

  @Test
  void answersOfRobotsOutsideTheFormationAreIgnored() {
    bothWell(1);
    watch.recordAnswer("r9", 1, false, 1);

    assertEquals(new Drive(1), watch.verdict(1));
  }

  @Test
  void leaderNeverCreepsWhileTheShapeHolds() {
    bothWell(1);
    watch.recordAnswer("r2", 0.0499, true, 1);

    assertTrue(assertInstanceOf(Drive.class, watch.verdict(1)).pace() >= 0.1);
  }

  private void bothWell(double now) {
    bothAnswer(0, now);
  }

  private void bothAnswer(double error, double now) {
    watch.recordAnswer("r2", error, true, now);
    watch.recordAnswer("r3", error, true, now);
  }
}
