package org.toqa.accounts;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;

class LoginThrottleTest {
  private Instant now = Instant.parse("2026-11-21T08:00:00Z");
  private final LoginThrottle throttle = new LoginThrottle(() -> now);

  @Test
  void eachFailureAfterTheFifthDoublesTheWait() {
    fail("ada", "10.0.0.1", 4);
    assertEquals(Duration.ZERO, throttle.remainingWait("ada", "10.0.0.1"));
    fail("ada", "10.0.0.1", 1);
    assertEquals(Duration.ofSeconds(1), throttle.remainingWait("ada", "10.0.0.1"));
    fail("ada", "10.0.0.1", 3);
    assertEquals(Duration.ofSeconds(8), throttle.remainingWait("ada", "10.0.0.1")); // 2^3
    fail("ada", "10.0.0.1", 20);
    assertEquals(Duration.ofMinutes(1), throttle.remainingWait("ada", "10.0.0.1"));
  }

  @Test
  void theWaitRunsOut() {
    fail("ada", "10.0.0.1", 7);

    now = now.plusSeconds(3);
    assertEquals(Duration.ofSeconds(1), throttle.remainingWait("ada", "10.0.0.1")); // of 2^2
    now = now.plusSeconds(1);
    assertEquals(Duration.ZERO, throttle.remainingWait("ada", "10.0.0.1"));
  }

  @Test
  void aNameIsSlowedFromEveryAddress() {
    for (int i = 0; i < 5; i++) {
      throttle.recordFailure("ada", "10.0.0." + i);
    }

    assertEquals(Duration.ofSeconds(1), throttle.remainingWait("ada", "10.0.0.99"));
    assertEquals(Duration.ZERO, throttle.remainingWait("bob", "10.0.0.1"));
  }

  @Test
  void anAddressThatTriesManyNamesIsSlowed() {
    for (int i = 0; i < 20; i++) {
      throttle.recordFailure("name" + i, "10.0.0.1");
    }

    assertEquals(Duration.ofSeconds(1), throttle.remainingWait("fresh", "10.0.0.1"));
    assertEquals(Duration.ZERO, throttle.remainingWait("fresh", "10.0.0.2"));
  }

  @Test
  void aSuccessForgivesTheName() {
    fail("ada", "10.0.0.1", 5);

    throttle.recordSuccess("ada");

    assertEquals(Duration.ZERO, throttle.remainingWait("ada", "10.0.0.1"));
  }

  @Test
  void failuresAreForgottenAfterAQuarterOfAnHour() {
    fail("ada", "10.0.0.1", 10);

    now = now.plus(Duration.ofMinutes(15)).plusMillis(1);
    fail("ada", "10.0.0.1", 1);

    assertEquals(Duration.ZERO, throttle.remainingWait("ada", "10.0.0.1"));
  }

  private void fail(String name, String address, int times) {
    for (int i = 0; i < times; i++) {
      throttle.recordFailure(name, address);
    }
  }
}
