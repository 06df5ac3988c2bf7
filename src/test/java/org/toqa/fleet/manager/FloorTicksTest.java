package org.toqa.fleet.manager;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Test;

class FloorTicksTest {
  private static final Set<String> BOTH = Set.of("hall", "yard");

  private final List<String> told = new ArrayList<>();
  private long nanos;
  private final FloorTicks ticks =
      new FloorTicks((floor, now) -> told.add(floor + " " + now.getEpochSecond()), () -> nanos);

  @Test
  void floorThatIsHeldUpIsToldTheNewestTimeWhenItIsReady() {
    tick(1);
    tick(2);
    tick(3);
    assertEquals(List.of("hall 1", "yard 1"), told.stream().sorted().toList());

    told.clear();
    ticks.end("hall");
    assertEquals(List.of("hall 3"), told);
    ticks.end("hall");
    assertEquals(List.of("hall 3"), told);
  }

  @Test
  void oldestTickIsThatOfTheFloorThatStands() {
    tick(1);
    nanos = 7;
    ticks.end("hall");
    tick(2);
    assertEquals(OptionalLong.of(0), ticks.runningSince());
    assertEquals(Instant.ofEpochSecond(1), ticks.floorTime());

    ticks.end("yard");
    assertEquals(OptionalLong.of(7), ticks.runningSince());
    ticks.end("yard");
    assertTrue(ticks.isRunning());
    ticks.end("hall");
    assertFalse(ticks.isRunning());
    assertEquals(OptionalLong.empty(), ticks.runningSince());
    assertEquals(Instant.ofEpochSecond(2), ticks.floorTime());
  }

  private void tick(int second) {
    ticks.tick(BOTH, Instant.ofEpochSecond(second));
  }
}
