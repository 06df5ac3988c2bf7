package org.toqa.fleet;

import io.github.bucket4j.Bucket;
import io.github.bucket4j.TimeMeter;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/** How often something may happen; by the time that ticks bring. Confined to one agent. */
public final class RateLimit {
  private final Bucket bucket;

  /**
   * @param burst so often at once, after a pause
   * @param times so often within the period, evenly
   * @param now of the time that ticks bring
   */
  public RateLimit(int burst, int times, Duration period, Supplier<Instant> now) {
    this.bucket =
        Bucket.builder()
            .addLimit(limit -> limit.capacity(burst).refillGreedy(times, period))
            .withCustomTimePrecision(new TickTime(now))
            .build();
  }

  /** Whether it may happen now, which counts. */
  public boolean tryAcquire() {
    return bucket.tryConsume(1);
  }

  private record TickTime(Supplier<Instant> now) implements TimeMeter {
    @Override
    public long currentTimeNanos() {
      Instant instant = now.get();
      return TimeUnit.SECONDS.toNanos(instant.getEpochSecond()) + instant.getNano();
    }

    @Override
    public boolean isWallClockBased() {
      return false;
    }
  }
}
