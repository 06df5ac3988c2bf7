package org.toqa.fleet.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.floor.ChargerWatch.Finding;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Place;

class ChargerWatchTest {
  private static final Place C1 = new Place("C1", new Vec2(1, 1));
  private static final Place C2 = new Place("C2", new Vec2(5, 1));

  private final ChargerWatch watch = new ChargerWatch(Duration.ofMinutes(10));
  private Instant now = Instant.parse("2026-11-21T08:00:00Z");

  @Test
  void aBatteryThatDoesNotRiseForTenMinutesSaysThatTheChargerFails() {
    assertEquals(Finding.UNCHANGED, seen(0, 0.18));
    assertEquals(Finding.UNCHANGED, seen(9, 0.19)); // one percent may be the gauge
    assertEquals(Finding.FAILED, seen(1, 0.18));
    assertEquals(Finding.UNCHANGED, seen(1, 0.18));

    assertTrue(watch.isFaulty(C1));
    assertFalse(watch.isFaulty(C2));
    assertEquals(
        "Charger C1 does not charge: the battery of r1 has not risen for 10 min. Robots use"
            + " other chargers where they can. Check the charger.",
        watch.faultyChargers().getFirst().text().english());
  }

  @Test
  void aBatteryThatRisesSlowlyIsCharged() {
    for (int percent = 20; percent < 40; percent += 2) {
      assertEquals(Finding.UNCHANGED, seen(9, percent / 100.0));
    }
    assertFalse(watch.isFaulty(C1));
  }

  @Test
  void theTimeBeginsAnewWhenTheRobotComesAgain() {
    seen(0, 0.18);
    watch.robotLeft("r1");

    assertEquals(Finding.UNCHANGED, seen(11, 0.18));
    assertEquals(Finding.UNCHANGED, watch.observe("r1", C2, 0.18, now.plusSeconds(3600)));
  }

  @Test
  void aChargerThatChargesAgainIsSoAtOnce() {
    seen(0, 0.18);
    seen(10, 0.14);

    assertEquals(Finding.RECOVERED, seen(1, 0.16)); // though it was at 18 % before
    assertFalse(watch.isFaulty(C1));
  }

  @Test
  void aChargerThatFailedIsTriedAgainAfterAnHour() {
    seen(0, 0.18);
    seen(10, 0.18);
    watch.robotLeft("r1");

    watch.forgetExpired(now.plus(Duration.ofMinutes(59)));
    assertTrue(watch.isFaulty(C1));
    watch.forgetExpired(now.plus(Duration.ofMinutes(60)));
    assertFalse(watch.isFaulty(C1));
  }

  private Finding seen(int minutesLater, double battery) {
    now = now.plus(Duration.ofMinutes(minutesLater));
    return watch.observe("r1", C1, battery, now);
  }
}
