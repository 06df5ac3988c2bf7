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

  /** A server that was off for longer is told to have a wrong clock, until its next start. */
  private static final Duration MAX_TIME_OFF = Duration.ofDays(30);

  private final HistoryPruner pruner;
  private final Duration trackRetention;
  private final Duration historyRetention;
  private final InstantSource clock;
  private final LongSupplier nanos;

  /** When the clock was right last. */
  private volatile Moment base;

  /** From the newest event of the time before to the start, by the wall clock. */
  private final Duration timeOff;

  private record Moment(Instant wall, long nanos) {}

  private final PeriodicWork work;

  /**
   * @param nanos of a clock that never jumps
   */
  RetentionJob(
      HistoryPruner pruner,
      Duration trackRetention,
      Duration historyRetention,
      InstantSource clock,
      LongSupplier nanos) {
    this.pruner = pruner;
    this.trackRetention = trackRetention;
    this.historyRetention = historyRetention;
    this.clock = clock;
    this.nanos = nanos;
    this.base = new Moment(clock.instant(), nanos.getAsLong());
    this.timeOff = Duration.between(newestEvent(), base.wall());
    work = new PeriodicWork("housekeeping", PERIOD, this::prune);
  }

  private Instant newestEvent() {
    try {
      return pruner.newestEvent().orElse(base.wall());
    } catch (StoreException e) {
      log.warn("The newest event cannot be read.", e);
      return base.wall();
    }
  }

  /** By how much the clock is ahead of the time that has really passed. */
  private Duration ahead() {
    if (timeOff.compareTo(MAX_TIME_OFF) > 0) {
      return timeOff;
    }
    Moment from = base;
    Instant expected = from.wall().plusNanos(nanos.getAsLong() - from.nanos());
    return Duration.between(expected, clock.instant());
  }

  void prune() {
    Instant now = clock.instant();
    Duration ahead = ahead();
    if (ahead.compareTo(MAX_AHEAD) > 0) {
      log.warn("Nothing is pruned, since the clock is {} days ahead.", ahead.toDays());
      return;
    }
    base = new Moment(now, nanos.getAsLong());
    try {
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
    Duration ahead = ahead();
    return ahead.compareTo(MAX_AHEAD) > 0
        ? Optional.of(Phrase.CLOCK_JUMPED.with(ahead.toDays()))
        : Optional.empty();
  }

  @Override
  public void close() {
    work.close();
  }
}
