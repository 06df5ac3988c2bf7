package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.toqa.allocation.Floors.NOON;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class AllocationTaskTest {

  @Test
  void eachLevelOfPriorityIsWorthAMinuteOfWaiting() {
    assertEquals(NOON, AllocationTask.waitingSince(NOON, 0, null));
    assertEquals(NOON.minusSeconds(600), AllocationTask.waitingSince(NOON, 10, null));
    assertEquals(NOON.plusSeconds(60), AllocationTask.waitingSince(NOON, -1, null));
  }

  @Test
  void aDeadlineIsWorthAtMostAnHour() {
    Duration hour = Duration.ofHours(1);
    assertEquals(NOON, AllocationTask.waitingSince(NOON, 0, NOON.plus(hour).plus(hour)));
    assertEquals(
        NOON.minusSeconds(1800), AllocationTask.waitingSince(NOON, 0, NOON.plusSeconds(1800)));
    assertEquals(
        NOON.minus(hour), AllocationTask.waitingSince(NOON, 0, NOON.minus(Duration.ofDays(9))));
  }
}
