package org.toqa.fleet.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorView.ChargerShortage;

class ChargerDemandTest {
  private final ChargerDemand demand = new ChargerDemand();
  private Instant now = Instant.parse("2026-11-23T08:00:00Z");

  /** Two charge, five work: 12 that do not wait keep 12 * 2 / 7, or four, charging points busy. */
  @Test
  void robotsThatWaitSayHowManyChargersWouldDo() {
    observe(40, 2, 5, 5);

    ChargerShortage shortage = demand.shortage(2, 12).orElseThrow();

    assertEquals(2, shortage.chargers());
    assertEquals(4, shortage.needed());
    assertEquals(
        "Too few chargers: in the last hour 5.0 robots on average waited to charge. The floor has"
            + " 2; 4 would do.",
        shortage.text().english());
  }

  @Test
  void nothingIsSaidInTheFirstHalfHour() {
    observe(29, 2, 5, 5);
    assertEquals(Optional.empty(), demand.shortage(2, 12));
    observe(2, 2, 5, 5);
    assertEquals(4, demand.shortage(2, 12).orElseThrow().needed());
  }

  @Test
  void oneThatWaitsNowAndThenIsNoShortage() {
    observe(35, 2, 0, 5);
    observe(25, 2, 1, 4);
    assertEquals(Optional.empty(), demand.shortage(2, 7));
  }

  @Test
  void whatIsMoreThanAnHourAgoIsForgotten() {
    observe(60, 2, 5, 5);
    observe(61, 3, 0, 9);
    assertEquals(Optional.empty(), demand.shortage(4, 12));
  }

  @Test
  void aQueueBeforeChargersThatAreEnoughIsNoShortage() {
    observe(60, 2, 1, 9);
    assertEquals(Optional.empty(), demand.shortage(3, 12));
  }

  /** Ten looks a minute. */
  private void observe(int minutes, int charging, int waiting, int other) {
    Duration step = Duration.ofSeconds(6);
    for (int i = 0; i < 10 * minutes; i++) {
      now = now.plus(step);
      demand.observe(charging, waiting, other, step, now);
    }
  }
}
