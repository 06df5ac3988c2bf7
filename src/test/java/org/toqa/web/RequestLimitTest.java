package org.toqa.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class RequestLimitTest {
  private long nanos;
  private final RequestLimit limit = new RequestLimit(10, () -> nanos);

  @Test
  void afterAPauseTwiceAsManyAreAnsweredAtOnce() {
    assertEquals(20, answered("ada", 50)); // two seconds' worth
    assertEquals(Duration.ofMillis(100), limit.tryAcquire("ada")); // 1 s / 10

    pass(Duration.ofSeconds(1));
    assertEquals(10, answered("ada", 50));
    pass(Duration.ofHours(1));
    assertEquals(20, answered("ada", 50));
  }

  @Test
  void whoAsksSteadilyIsAlwaysAnswered() {
    for (int i = 0; i < 1000; i++) {
      pass(Duration.ofMillis(100));
      assertEquals(Duration.ZERO, limit.tryAcquire("ada"));
    }
  }

  @Test
  void withoutALimitEverybodyIsAnswered() {
    RequestLimit none = new RequestLimit(0, () -> nanos);

    for (int i = 0; i < 10_000; i++) {
      assertEquals(Duration.ZERO, none.tryAcquire("ada"));
    }
  }

  @Test
  void aFloodOfAddressesTakesNoMoreMemoryAndHelpsNobodyWhoAsksTooFast() {
    answered("ada", 50);

    for (int i = 0; i < 100_000; i++) {
      limit.tryAcquire("address " + i);
      assertTrue(i % 100 != 0 || limit.tryAcquire("ada").isPositive());
    }

    assertTrue(limit.callerCount() <= 10_000);
  }

  @Test
  void whoIsQuietIsForgotten() {
    answered("ada", 50);

    pass(Duration.ofSeconds(2));

    assertEquals(0, limit.callerCount());
  }

  private int answered(String caller, int requests) {
    int count = 0;
    for (int i = 0; i < requests; i++) {
      count += limit.tryAcquire(caller).isZero() ? 1 : 0;
    }
    return count;
  }

  private void pass(Duration time) {
    nanos += time.toNanos();
  }
}
