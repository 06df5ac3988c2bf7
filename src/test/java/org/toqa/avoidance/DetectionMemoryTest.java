package org.toqa.avoidance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class DetectionMemoryTest {
  private static final Vec2 THING = new Vec2(1, 0);

  private final DetectionMemory sightings = new DetectionMemory();

  @Test
  void aThingIsRememberedForAWhile() {
    sightings.remember(List.of(THING), 10);

    sightings.forgetOld(10 + DetectionMemory.MEMORY_SECONDS - 0.01);
    assertEquals(List.of(THING), sightings.points());
    sightings.forgetOld(10 + DetectionMemory.MEMORY_SECONDS + 0.01);
    assertEquals(List.of(), sightings.points());
  }

  @Test
  void aThingSeenAgainIsOneAndRememberedAnew() {
    sightings.remember(List.of(THING), 10);
    sightings.remember(List.of(new Vec2(1.005, 0)), 12);

    sightings.forgetOld(12 + DetectionMemory.MEMORY_SECONDS - 0.01);
    assertEquals(List.of(THING), sightings.points());
  }

  @Test
  void aBeamThatSweepsAlongAThingLeavesARowOfPoints() {
    for (double y = 0; y < 0.31; y += 0.02) {
      sightings.remember(List.of(new Vec2(1, y)), 10);
    }

    assertEquals(8, sightings.points().size(), sightings.points().toString()); // 0, 0.04, ... 0.28
  }
}
