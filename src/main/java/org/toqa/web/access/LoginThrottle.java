package org.toqa.web.access;

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
  private static final int FREE_FAILURES_OF_A_NAME = 5;
  private static final int FREE_FAILURES_OF_AN_ADDRESS = 20;
  private static final Duration LONGEST_WAIT = Duration.ofMinutes(1);
  private static final Duration MEMORY = Duration.ofMinutes(15);
  private static final int REMEMBERED = 10_000;

  private record Failures(int count, Instant last) {}

  private final InstantSource clock;
  private final Map<String, Failures> byKey = new LinkedHashMap<>();

  public LoginThrottle(InstantSource clock) {
    this.clock = clock;
  }

  /** How long until the next attempt is looked at; zero when it may come now. */
  public synchronized Duration untilNext(String name, String address) {
    Duration ofName = untilNext(nameKey(name), FREE_FAILURES_OF_A_NAME);
    Duration ofAddress = untilNext(addressKey(address), FREE_FAILURES_OF_AN_ADDRESS);
    return ofName.compareTo(ofAddress) > 0 ? ofName : ofAddress;
  }

  public synchronized void failed(String name, String address) {
    count(nameKey(name));
    count(addressKey(address));
  }

  public synchronized void succeeded(String name) {
    byKey.remove(nameKey(name));
  }

  private Duration untilNext(String key, int free) {
    Failures failures = byKey.get(key);
    if (failures == null || failures.count < free || isForgotten(failures)) {
      return Duration.ZERO;
    }
    long doublings = Math.min(failures.count - free, 10);
    Duration wait = Duration.ofSeconds(1L << doublings);
    Instant next = failures.last.plus(wait.compareTo(LONGEST_WAIT) > 0 ? LONGEST_WAIT : wait);
    Duration left = Duration.between(clock.instant(), next);
    return left.isNegative() ? Duration.ZERO : left;
  }

  private void count(String key) {
    Failures before = byKey.remove(key);
    int count = before == null || isForgotten(before) ? 1 : before.count + 1;
    byKey.put(key, new Failures(count, clock.instant()));
    if (byKey.size() > REMEMBERED) {
      byKey.remove(byKey.keySet().iterator().next());
    }
  }

  private boolean isForgotten(Failures failures) {
    return failures.last.plus(MEMORY).isBefore(clock.instant());
  }

  private static String nameKey(String name) {
    return "name " + name;
  }

  private static String addressKey(String address) {
    return "address " + address;
  }
}
