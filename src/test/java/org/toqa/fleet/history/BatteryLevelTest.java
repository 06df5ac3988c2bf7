package org.toqa.fleet.history;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import org.junit.jupiter.api.Test;

class BatteryLevelTest {
  private static final Instant AT = Instant.parse("2026-11-21T08:00:00Z");
  private static final BatteryLevel HALF = new BatteryLevel("r1", AT, 0.5);

  @Test
  void aLevelIsNewWhenItIsAnotherWholePercentAndNotTooSoon() {
    assertTrue(new BatteryLevel("r1", AT.plusSeconds(60), 0.49).isNewAfter(HALF));
    assertFalse(new BatteryLevel("r1", AT.plusSeconds(60), 0.498).isNewAfter(HALF));
    assertFalse(new BatteryLevel("r1", AT.plusSeconds(1), 0.1).isNewAfter(HALF));
  }
}
