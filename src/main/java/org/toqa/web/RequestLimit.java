package org.toqa.web;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import com.github.benmanes.caffeine.cache.Ticker;
import io.github.bucket4j.Bucket;
import io.github.bucket4j.TimeMeter;
import java.time.Duration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.accounts.Secret;

/**
 * How fast one caller may ask: so many requests a second, and after a pause twice as many at once.
 * Each caller has a bucket of tokens; of very many callers those who ask often are remembered, and
 * the others begin anew with a full one.
 */
public final class RequestLimit {
  private static final Logger LOG = LoggerFactory.getLogger(RequestLimit.class);
  private static final int MAX_CALLERS = 10_000;
  private static final Duration REFILL_TIME = Duration.ofSeconds(2);
  private static final Duration KNOWN_TIME = Duration.ofMinutes(10);
  private static final Duration LOG_INTERVAL = Duration.ofMinutes(1);

  private final int perSecond;
  private final TimeMeter time;
  private final Cache<String, Bucket> buckets;

  /** Hashes of secrets that were somebody's. */
  private final Cache<String, Boolean> known;

  private final Bucket logLines;

  /**
   * @param perSecond 0: everybody may ask as fast as he can
   */
  public RequestLimit(int perSecond, Ticker ticker) {
    this.perSecond = perSecond;
    this.time = new TickerTime(ticker);
    this.buckets =
        Caffeine.newBuilder()
            .maximumSize(MAX_CALLERS)
            .expireAfterAccess(REFILL_TIME)
            .ticker(ticker)
            .executor(Runnable::run)
            .build();
    this.known =
        Caffeine.newBuilder()
            .maximumSize(MAX_CALLERS)
            .expireAfterAccess(KNOWN_TIME)
            .ticker(ticker)
            .executor(Runnable::run)
            .build();
    this.logLines =
        Bucket.builder()
            .addLimit(limit -> limit.capacity(1).refillIntervally(1, LOG_INTERVAL))
            .withCustomTimePrecision(time)
            .build();
  }

  /** How long until this caller may ask; zero when he may now, which counts as a request. */
  public Duration tryAcquire(String caller) {
    if (perSecond == 0) {
      return Duration.ZERO;
    }
    var probe = buckets.get(caller, unknown -> fullBucket()).tryConsumeAndReturnRemaining(1);
    if (probe.isConsumed()) {
      return Duration.ZERO;
    }
    if (logLines.tryConsume(1)) {
      LOG.warn("The {} asks more than {} times a second, and is told to wait.", caller, perSecond);
    }
    return Duration.ofNanos(probe.getNanosToWaitForRefill());
  }

  /** Whether that secret was somebody's a moment ago. */
  public boolean isKnown(String secret) {
    return known.getIfPresent(Secret.hash(secret)) != null;
  }

  /** Remembers whether that secret is somebody's. */
  public void setKnown(String secret, boolean isGood) {
    if (isGood) {
      known.put(Secret.hash(secret), true);
    } else {
      known.invalidate(Secret.hash(secret));
    }
  }

  private Bucket fullBucket() {
    return Bucket.builder()
        .addLimit(
            limit ->
                limit
                    .capacity(perSecond * REFILL_TIME.toSeconds())
                    .refillGreedy(perSecond, Duration.ofSeconds(1)))
        .withCustomTimePrecision(time)
        .build();
  }

  /** How many callers are remembered. */
  long callerCount() {
    buckets.cleanUp();
    return buckets.estimatedSize();
  }

  private record TickerTime(Ticker ticker) implements TimeMeter {
    @Override
    public long currentTimeNanos() {
      return ticker.read();
    }

    @Override
    public boolean isWallClockBased() {
      return false;
    }
  }
}
