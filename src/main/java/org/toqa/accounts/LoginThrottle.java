package org.toqa.accounts;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.TimeUnit;

/**
 * Slows guessing: after a few failures each further one doubles the wait, up to a minute, for that
 * user name and for that address. Nobody is locked out for longer. Failures are forgotten after a
 * quarter of an hour without another, and those that matter least when there are very many.
 */
public final class LoginThrottle {
  private static final int FREE_FAILURES_PER_NAME = 5;
  private static final int FREE_FAILURES_PER_ADDRESS = 20;
  private static final Duration MAX_WAIT = Duration.ofMinutes(1);
  private static final Duration EXPIRY = Duration.ofMinutes(15);
  private static final int MAX_ENTRIES = 10_000;

  /**
   * @param last when the newest of them was
   */
  private record Failures(int count, Instant last) {}

  private final InstantSource clock;
  private final Cache<String, Failures> failures;

  public LoginThrottle(InstantSource clock) {
    this.clock = clock;
    this.failures =
        Caffeine.newBuilder()
            .maximumSize(MAX_ENTRIES)
            .expireAfterWrite(EXPIRY)
            .ticker(() -> TimeUnit.MILLISECONDS.toNanos(clock.millis()))
            .executor(Runnable::run)
            .build();
  }

  /** How long until the next attempt is looked at; zero when it may come now. */
  public Duration remainingWait(String name, String address) {
    Duration ofName = remainingWait(nameKey(name), FREE_FAILURES_PER_NAME);
    Duration ofAddress = remainingWait(addressKey(address), FREE_FAILURES_PER_ADDRESS);
    return ofName.compareTo(ofAddress) > 0 ? ofName : ofAddress;
  }

  public void recordFailure(String name, String address) {
    recordFailureOf(nameKey(name));
    recordFailureOf(addressKey(address));
  }

  public void recordSuccess(String name) {
    failures.invalidate(nameKey(name));
  }

  private Duration remainingWait(String key, int free) {
    Failures known = failures.getIfPresent(key);
    if (known == null || known.count < free) {
      return Duration.ZERO;
    }
    long doublings = Math.min(known.count - free, 10);
    Duration wait = Duration.ofSeconds(1L << doublings);
    Instant next = known.last.plus(wait.compareTo(MAX_WAIT) > 0 ? MAX_WAIT : wait);
    Duration left = Duration.between(clock.instant(), next);
    return left.isNegative() ? Duration.ZERO : left;
  }

  private void recordFailureOf(String key) {
    failures
        .asMap()
        .merge(
            key,
            new Failures(1, clock.instant()),
            (before, now) -> new Failures(before.count + 1, now.last));
  }

  private static String nameKey(String name) {
    return "name " + name;
  }

  private static String addressKey(String address) {
    return "address " + address;
  }
}
