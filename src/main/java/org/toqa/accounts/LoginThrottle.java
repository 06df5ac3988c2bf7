package org.toqa.accounts;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.TimeUnit;

/**
 * Slows guessing: after a few failures each further one doubles the wait, up to a minute.
 *
 * <ul>
 *   <li>Failures with a name count for that name from that address only ({@link AddressBlock}): who
 *       guesses elsewhere keeps nobody out.
 *   <li>Failures from an address count for all names from there.
 *   <li>Where a name fails very often, from wherever, each address has but one failure free with
 *       it.
 * </ul>
 *
 * The check and the count are one step: an attempt counts as a failure while it is looked at, so
 * many at once get no further than one after the other. Failures are forgotten after a quarter of
 * an hour without another, and those that matter least when there are very many.
 */
public final class LoginThrottle {
  private static final int FREE_FAILURES_PER_NAME = 5;
  private static final int FREE_FAILURES_PER_GUESSED_NAME = 1;
  private static final int FREE_FAILURES_PER_ADDRESS = 20;

  /** A name that failed so often, from anywhere, is being guessed. */
  private static final int FAILURES_OF_GUESSED_NAME = 100;

  /** More than a shift that begins behind one address. */
  private static final int MAX_OPEN_PER_ADDRESS = 100;

  private static final Duration MAX_WAIT = Duration.ofMinutes(1);
  private static final Duration SHORTEST_WAIT = Duration.ofSeconds(1);
  private static final Duration EXPIRY = Duration.ofMinutes(15);
  private static final int MAX_ENTRIES = 10_000;

  /** What became of an attempt. */
  public enum Result {
    SUCCESS,
    FAILURE,
    /** It could not be looked at. */
    UNKNOWN
  }

  /**
   * @param open attempts that are being looked at
   * @param last when the newest failure was
   */
  private record Attempts(int failures, int open, Instant last) {
    private Duration remainingWait(int free, Instant now) {
      if (failures < free) {
        return Duration.ZERO;
      }
      Duration wait = Duration.ofSeconds(1L << Math.min(failures - free, 10));
      Instant next = last.plus(wait.compareTo(MAX_WAIT) > 0 ? MAX_WAIT : wait);
      Duration left = Duration.between(now, next);
      return left.isNegative() ? Duration.ZERO : left;
    }

    /**
     * @param maxOpen how many may be looked at at once before there are too many failures
     */
    private Duration wait(int free, int maxOpen, Instant now) {
      Duration wait = remainingWait(free, now);
      boolean isFull = open >= (failures < free ? maxOpen : 1);
      return wait.isZero() && isFull ? SHORTEST_WAIT : wait;
    }
  }

  private final InstantSource clock;
  private final Cache<String, Attempts> attempts;

  public LoginThrottle(InstantSource clock) {
    this.clock = clock;
    this.attempts =
        Caffeine.newBuilder()
            .maximumSize(MAX_ENTRIES)
            .expireAfterWrite(EXPIRY)
            .ticker(() -> TimeUnit.MILLISECONDS.toNanos(clock.millis()))
            .executor(Runnable::run)
            .build();
  }

  /**
   * Begins an attempt if it may be looked at now; then {@link #end} is called, whatever happens.
   *
   * @return zero, or how long until the next attempt may begin
   */
  public synchronized Duration tryBegin(String name, String address) {
    Instant now = clock.instant();
    String block = AddressBlock.of(address);
    boolean isGuessed = of(nameKey(name)).failures >= FAILURES_OF_GUESSED_NAME;
    int free = isGuessed ? FREE_FAILURES_PER_GUESSED_NAME : FREE_FAILURES_PER_NAME;
    Attempts pair = of(pairKey(name, block));
    Duration ofPair = pair.wait(free, Math.max(1, free - pair.failures), now);
    Duration ofAddress =
        of(addressKey(block)).wait(FREE_FAILURES_PER_ADDRESS, MAX_OPEN_PER_ADDRESS, now);
    Duration wait = ofPair.compareTo(ofAddress) > 0 ? ofPair : ofAddress;
    if (wait.isZero()) {
      change(pairKey(name, block), 0, 1);
      change(addressKey(block), 0, 1);
    }
    return wait;
  }

  public synchronized void end(String name, String address, Result result) {
    String block = AddressBlock.of(address);
    int failures = result == Result.FAILURE ? 1 : 0;
    change(addressKey(block), failures, -1);
    change(nameKey(name), failures, 0);
    if (result == Result.SUCCESS) {
      attempts.invalidate(pairKey(name, block));
    } else {
      change(pairKey(name, block), failures, -1);
    }
  }

  private Attempts of(String key) {
    Attempts known = attempts.getIfPresent(key);
    return known == null ? new Attempts(0, 0, Instant.MIN) : known;
  }

  private void change(String key, int failures, int open) {
    Attempts old = of(key);
    Attempts next =
        new Attempts(
            old.failures + failures,
            Math.max(0, old.open + open),
            failures > 0 ? clock.instant() : old.last);
    if (next.failures + next.open > 0) {
      attempts.put(key, next);
    } else {
      attempts.invalidate(key);
    }
  }

  private static String nameKey(String name) {
    return "name " + name;
  }

  private static String addressKey(String block) {
    return "address " + block;
  }

  private static String pairKey(String name, String block) {
    return "pair " + block + " " + name;
  }
}
