package org.toqa.app.bench.meter;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class WaitMeterTest {
  private static final long SECOND = 1_000_000_000L;
  private static final Vec2 HERE = new Vec2(1, 1);

  private final WaitMeter waits = new WaitMeter(new Vec2[] {HERE, HERE});

  @Test
  void tellsWhoStoodLongestAndWhatWasSaidOfThat() {
    observe(0, 0, 2);
    waits.setReason(0, "Waiting for r2");
    observe(0, 2, 10);
    waits.setReason(0, null);
    observe(0, 10, 11);
    waits.observe(0, new Vec2(1.06, 1), 11 * SECOND); // it moves
    observe(1, 0, 5);

    assertEquals(11, waits.longest());
    assertEquals(0, waits.longestRobot());
    assertEquals("Waiting for r2", waits.longestReason());
    assertEquals(5, waits.longestUnnamed()); // the other one
  }

  @Test
  void aNewGoalBeginsANewWait() {
    observe(0, 0, 3);
    waits.setGoal(0, 3 * SECOND);
    observe(0, 3, 5);

    assertEquals(3, waits.longest());
  }

  private void observe(int robot, int from, int to) {
    for (int second = from; second <= to; second++) {
      waits.observe(robot, HERE, second * SECOND);
    }
  }
}
