package org.toqa.app.server;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.persistence.StoreException;
import org.toqa.store.HistoryPruner;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Prunes the store every hour, on a thread of its own; but nothing while the wall clock is far
 * ahead of the time that has really passed, or was set so while no server ran.
 */
final class RetentionJob implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(RetentionJob.class);
  private static final Duration PERIOD = Duration.ofHours(1);

  /** A computer may sleep for so long while the server runs; its monotonic clock stands then. */
  private static final Duration MAX_AHEAD = Duration.ofDays(4);

  /**
   * A server that was off for longer is told to have a wrong clock, until that is set or the server
   * started again.
   */
  private static final Duration MAX_TIME_OFF = Duration.ofDays(30);

  private final HistoryPruner pruner;
  private final Duration trackRetention;
  private final Duration historyRetention;
  private final InstantSource clock;
  private final LongSupplier nanos;

  /** When the clock was right last. */
  private volatile Moment base;

  /**
   * @param tolerance how far ahead the clock may be of the time that passes from then on
   */
  private record Moment(Instant wall, long nanos, Duration tolerance) {}

  private final PeriodicWork work;

  /**
   * @param newestEvent when it was, of those before this start, which adds one by the clock of now;
   *     empty: there was none
   * @param nanos of a clock that never jumps
   */
  RetentionJob(
      HistoryPruner pruner,
      Duration trackRetention,
      Duration historyRetention,
      Optional<Instant> newestEvent,
      InstantSource clock,
      LongSupplier nanos) {
    this.pruner = pruner;
    this.trackRetention = trackRetention;
    this.historyRetention = historyRetention;
    this.clock = clock;
    this.nanos = nanos;
    Instant start = clock.instant();
    this.base =
        newestEvent
            .filter(last -> Duration.between(last, start).compareTo(MAX_TIME_OFF) > 0)
            .map(last -> new Moment(last, nanos.getAsLong(), MAX_TIME_OFF))
            .orElseGet(() -> new Moment(start, nanos.getAsLong(), MAX_AHEAD));
    work = new PeriodicWork("housekeeping", PERIOD, this::prune);
  }

  /** By how much the clock is ahead of the time that has really passed; empty: by little. */
  private Optional<Duration> ahead() {
    Moment from = base;
    Instant expected = from.wall().plusNanos(nanos.getAsLong() - from.nanos());
    return Optional.of(Duration.between(expected, clock.instant()))
        .filter(ahead -> ahead.compareTo(from.tolerance()) > 0);
  }

  void prune() {
    Instant now = clock.instant();
    Optional<Duration> ahead = ahead();
    if (ahead.isPresent()) {
      log.warn("Nothing is pruned, since the clock is {} days ahead.", ahead.get().toDays());
      return;
    }
    base = new Moment(now, nanos.getAsLong(), MAX_AHEAD);
    try {
      pruner.pruneExpired(now.minus(MAX_TIME_OFF)); // a clock that is ahead by less is not noticed
      long points = pruner.pruneTracks(now.minus(trackRetention));
      long tasks = pruner.pruneHistory(now.minus(historyRetention));
      if (points + tasks > 0) {
        log.info("Pruned {} points of tracks and {} ended tasks.", points, tasks);
      }
    } catch (StoreException e) {
      log.warn("Nothing could be pruned; it is tried again in an hour.", e);
    }
  }

  /** What people should know of the clock. */
  Optional<Sentence> warning() {
    return ahead().map(ahead -> Phrase.CLOCK_JUMPED.with(ahead.toDays()));
  }

  @Override
  public void close() {
    work.close();
  }
}
