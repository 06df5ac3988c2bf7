package org.toqa.link.gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class RejectedGatewaysTest {
  private final AtomicLong nanos = new AtomicLong();
  private final RejectedGateways rejected = new RejectedGateways(nanos::get);

  @Test
  void aFloodIsLoggedOnceAMinute() {
    assertTrue(rejected.record("10.0.0.1", "it does not encrypt"));
    assertFalse(rejected.record("10.0.0.1", "it does not encrypt"));
    assertTrue(rejected.record("10.0.0.2", "it does not encrypt"));
    nanos.addAndGet(60_000_000_000L);
    assertTrue(rejected.record("10.0.0.1", "it does not encrypt"));
  }

  @Test
  void alsoOneFromManyAddresses() {
    assertEquals(
        20,
        IntStream.range(0, 1_000)
            .filter(i -> rejected.record("10.0.0." + i, "it does not encrypt"))
            .count());
  }
}
