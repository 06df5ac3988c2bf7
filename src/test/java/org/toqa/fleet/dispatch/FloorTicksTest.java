package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

class FloorTicksTest {
  private final List<Long> told = new ArrayList<>();
  private long nanos;
  private final FloorTicks ticks =
      new FloorTicks(now -> told.add(now.getEpochSecond()), () -> nanos);

  @Test
  void floorThatIsHeldUpIsToldTheNewestTimeWhenItIsReady() {
    tick(1);
    tick(2);
    tick(3);
    assertEquals(List.of(1L), told);

    ticks.end();
    assertEquals(List.of(1L, 3L), told);
    ticks.end();
    assertEquals(List.of(1L, 3L), told);
  }

  @Test
  void floorIsAtTheTickThatRuns() {
    tick(1);
    nanos = 7;
    tick(2);
    assertEquals(OptionalLong.of(0), ticks.runningSince());
    assertEquals(Instant.ofEpochSecond(1), ticks.floorTime());

    ticks.end();
    assertTrue(ticks.isRunning());
    assertEquals(OptionalLong.of(7), ticks.runningSince());
    ticks.end();
    assertFalse(ticks.isRunning());
    assertEquals(OptionalLong.empty(), ticks.runningSince());
    assertEquals(Instant.ofEpochSecond(2), ticks.floorTime());
  }

  @Test
  void floorWithNothingToDoIsToldOnceASecondAndIsStillUpToDate() {
    for (int tenth = 10; tenth <= 30; tenth++) {
      Instant now = Instant.ofEpochMilli(100L * tenth);
      ticks.tick(now, true);
      assertEquals(now, ticks.floorTime());
      ticks.end();
    }
    assertEquals(List.of(1L, 2L, 3L), told);

    ticks.tick(Instant.ofEpochMilli(3100), false);
    assertEquals(List.of(1L, 2L, 3L, 3L), told, "it has something to do");
  }

  private void tick(int second) {
    ticks.tick(Instant.ofEpochSecond(second), false);
  }
}
