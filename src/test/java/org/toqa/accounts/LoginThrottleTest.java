package org.toqa.accounts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.LoginThrottle.Result;

class LoginThrottleTest {
  private static final String HERE = "10.0.0.1";
  private Instant now = Instant.parse("2026-11-21T08:00:00Z");
  private final LoginThrottle throttle = new LoginThrottle(() -> now);

  @Test
  void eachFailureAfterTheFifthDoublesTheWait() {
    fail("ada", HERE, 4);
    assertEquals(Duration.ZERO, waitFor("ada", HERE));
    fail("ada", HERE, 1);
    assertEquals(Duration.ofSeconds(1), waitFor("ada", HERE));
    fail("ada", HERE, 3);
    assertEquals(Duration.ofSeconds(8), waitFor("ada", HERE)); // 2^3
    fail("ada", HERE, 20);
    assertEquals(Duration.ofMinutes(1), waitFor("ada", HERE));
  }

  @Test
  void theWaitRunsOut() {
    fail("ada", HERE, 7);
    Instant failedAt = now;

    now = failedAt.plusSeconds(3);
    assertEquals(Duration.ofSeconds(1), waitFor("ada", HERE)); // of 2^2
    now = failedAt.plusSeconds(4);
    assertEquals(Duration.ZERO, waitFor("ada", HERE));
  }

  @Test
  void whoGuessesElsewhereKeepsNobodyOut() {
    for (int i = 0; i < 500; i++) {
      fail("ada", "10.0.%d.%d".formatted(1 + i / 250, i % 250), 1);
    }
    assertEquals(Duration.ZERO, waitFor("ada", HERE));

    // a slip costs him a wait of his own, which nobody else makes longer
    fail("ada", HERE, 1);
    assertEquals(Duration.ofSeconds(1), waitFor("ada", HERE));
    for (int i = 0; i < 30; i++) {
      fail("ada", "10.0.8." + i, 1);
    }
    now = now.plusSeconds(1);
    assertEquals(Duration.ZERO, waitFor("ada", HERE));
  }

  @Test
  void anAddressThatTriesManyNamesIsSlowed() {
    for (int i = 0; i < 20; i++) {
      fail("name" + i, HERE, 1);
    }

    assertEquals(Duration.ofSeconds(1), waitFor("fresh", HERE));
    assertEquals(Duration.ZERO, waitFor("fresh", "10.0.0.2"));
  }

  @Test
  void theAddressesOfOneSubscriberCountAsOne() {
    for (int i = 1; i <= 5; i++) {
      fail("ada", "2001:db8:1:2::" + i, 1);
    }

    assertEquals(Duration.ofSeconds(1), waitFor("ada", "2001:db8:1:2:ffff::9"));
    assertEquals(Duration.ZERO, waitFor("ada", "2001:db8:1:3::1"), "another subscriber");
  }

  @Test
  void manyAttemptsAtOnceGetNoFurtherThanOneAfterTheOther() {
    long begun =
        IntStream.range(0, 50).filter(i -> throttle.tryBegin("ada", HERE).isZero()).count();

    assertEquals(5, begun);
    assertTrue(throttle.tryBegin("bob", HERE).isZero(), "of another name");
  }

  @Test
  void aSuccessForgivesTheName() {
    fail("ada", HERE, 4);

    assertEquals(Duration.ZERO, throttle.tryBegin("ada", HERE));
    throttle.end("ada", HERE, Result.SUCCESS);

    fail("ada", HERE, 4);
    assertEquals(Duration.ZERO, waitFor("ada", HERE));
  }

  @Test
  void failuresAreForgottenAfterAQuarterOfAnHour() {
    fail("ada", HERE, 10);

    now = now.plus(Duration.ofMinutes(15)).plusMillis(1);
    fail("ada", HERE, 1);

    assertEquals(Duration.ZERO, waitFor("ada", HERE));
  }

  /** As they would be if each waited until it is looked at. */
  private void fail(String name, String address, int times) {
    for (int i = 0; i < times; i++) {
      Duration wait = throttle.tryBegin(name, address);
      while (wait.isPositive()) {
        now = now.plus(wait);
        wait = throttle.tryBegin(name, address);
      }
      throttle.end(name, address, Result.FAILURE);
    }
  }

  /** How long an attempt would wait now. */
  private Duration waitFor(String name, String address) {
    Duration wait = throttle.tryBegin(name, address);
    if (wait.isZero()) {
      throttle.end(name, address, Result.UNKNOWN);
    }
    return wait;
  }
}
