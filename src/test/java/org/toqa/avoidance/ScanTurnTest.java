package org.toqa.avoidance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

class ScanTurnTest {
  private static final double TICK = 0.02;
  private static final Pose POSE = new Pose(1, 2, 0);

  private final ScanTurn glance = new ScanTurn();

  @Test
  void theRobotLooksToBothSidesWithinTheTimeThatItRemembers() {
    double left = 0;
    double right = 0;
    for (double t = 0; t < DetectionMemory.MEMORY_SECONDS; t += TICK) {
      glance.step(true, TICK);
      double heading = glance.turned(POSE).theta();
      left = Math.max(left, heading);
      right = Math.min(right, heading);
    }

    assertEquals(Math.toRadians(50), left, 1e-9);
    assertEquals(Math.toRadians(-50), right, 1e-9);
  }

  @Test
  void aRobotThatMustNotMoveStaysTurnedAsItIs() {
    glance.step(true, 0.5);
    glance.hold();

    assertEquals(0.5, glance.turned(POSE).theta(), 1e-9);
    assertSame(Twist.ZERO, glance.turned(Twist.ZERO));
    assertFalse(glance.isStraight());
  }

  @Test
  void itTurnsBackAndIsExactlyStraightAgain() {
    for (int i = 0; i < 30; i++) {
      glance.step(true, TICK);
    }
    glance.step(false, TICK);
    assertEquals(-1, glance.turned(Twist.ZERO).w(), 1e-9);
    assertFalse(glance.isStraight());

    for (int i = 0; i < 31; i++) {
      glance.step(false, TICK);
    }

    assertTrue(glance.isStraight());
    assertSame(POSE, glance.turned(POSE));
    assertSame(Twist.ZERO, glance.turned(Twist.ZERO));
  }
}
