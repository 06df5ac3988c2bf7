package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class PoseErrorTest {

  @Test
  void errorDriftsByASmallShareOfTheWayWithinItsBound() {
    PoseError error = new PoseError(0.02, 1);
    double largest = 0;
    double drifted = 0;
    for (int step = 0; step < 100_000; step++) { // 500 m
      Vec2 before = error.offset();
      error.advance(0.005);
      drifted += before.distanceTo(error.offset());
      assertTrue(before.distanceTo(error.offset()) <= 0.005 * 0.02 + 1e-12);
      largest = Math.max(largest, error.offset().distanceTo(Vec2.ZERO));
    }
    assertTrue(largest <= 0.02 && largest > 0.019, "largest " + largest);
    assertEquals(10, drifted, 0.2); // 2 % of 500 m
  }

  @Test
  void errorBeginsWithTheRobotAndStaysWhileThatStands() {
    PoseError error = new PoseError(0.02, 2);
    Vec2 start = error.offset();
    error.advance(0);

    assertTrue(start.distanceTo(Vec2.ZERO) > 0);
    assertEquals(start, error.offset());
    assertEquals(Vec2.ZERO.distanceTo(new PoseError(0, 2).offset()), 0);
  }
}
