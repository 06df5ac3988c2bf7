package org.toqa.accounts;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Slows guessing: after a few failures each further one doubles the wait, up to a minute, for that
 * user name and for that address. Nobody is locked out for longer. Failures are forgotten after a
 * quarter of an hour of quiet, and the oldest ones when there are very many.
 */
public final class LoginThrottle {
  private static final int FREE_FAILURES_PER_NAME = 5;
  private static final int FREE_FAILURES_PER_ADDRESS = 20;
  private static final Duration MAX_WAIT = Duration.ofMinutes(1);
  private static final Duration EXPIRY = Duration.ofMinutes(15);
  private static final int MAX_ENTRIES = 10_000;

  private record Failures(int count, Instant last) {}

  private final InstantSource clock;
  private final Map<String, Failures> byKey = new LinkedHashMap<>();

  public LoginThrottle(InstantSource clock) {
    this.clock = clock;
  }

  /** How long until the next attempt is looked at; zero when it may come now. */
  public synchronized Duration remainingWait(String name, String address) {
    Duration ofName = remainingWait(nameKey(name), FREE_FAILURES_PER_NAME);
    Duration ofAddress = remainingWait(addressKey(address), FREE_FAILURES_PER_ADDRESS);
    return ofName.compareTo(ofAddress) > 0 ? ofName : ofAddress;
  }

  public synchronized void recordFailure(String name, String address) {
    recordFailureOf(nameKey(name));
    recordFailureOf(addressKey(address));
  }

  public synchronized void recordSuccess(String name) {
    byKey.remove(nameKey(name));
  }

  private Duration remainingWait(String key, int free) {
    Failures failures = byKey.get(key);
    if (failures == null || failures.count < free || isExpired(failures)) {
      return Duration.ZERO;
    }
    long doublings = Math.min(failures.count - free, 10);
    Duration wait = Duration.ofSeconds(1L << doublings);
    Instant next = failures.last.plus(wait.compareTo(MAX_WAIT) > 0 ? MAX_WAIT : wait);
    Duration left = Duration.between(clock.instant(), next);
    return left.isNegative() ? Duration.ZERO : left;
  }

  private void recordFailureOf(String key) {
    Failures before = byKey.remove(key);
    int count = before == null || isExpired(before) ? 1 : before.count + 1;
    byKey.put(key, new Failures(count, clock.instant()));
    if (byKey.size() > MAX_ENTRIES) {
      byKey.remove(byKey.keySet().iterator().next());
    }
  }

  private boolean isExpired(Failures failures) {
    return failures.last.plus(EXPIRY).isBefore(clock.instant());
  }

  private static String nameKey(String name) {
    return "name " + name;
  }

  private static String addressKey(String address) {
    return "address " + address;
  }
}
