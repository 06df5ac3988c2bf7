package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class SteadyClockTest {
  private static final Instant START = Instant.parse("2026-11-21T10:00:00Z");

  @Test
  void itGoesOnAsTimeReallyPasses() {
    AtomicLong nanos = new AtomicLong(-5);
    SteadyClock clock = new SteadyClock(START, nanos::get);
    assertEquals(START, clock.instant());

    nanos.addAndGet(Duration.ofMinutes(1).toNanos());

    assertEquals(START.plusSeconds(60), clock.instant());
  }
}
