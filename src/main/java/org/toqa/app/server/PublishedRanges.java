package org.toqa.app.server;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.localisation.RangeSource;
import org.toqa.localisation.Walls;

/**
 * The newest ranges of each robot of a site that has asked for its own, from the thread that hears
 * them to that of its link. What is older than a moment is of another place. Any thread may call
 * it.
 */
final class PublishedRanges {
  private static final long FRESH_NANOS = Duration.ofMillis(150).toNanos();

  private final Map<String, AtomicReference<@Nullable Heard>> newest = new ConcurrentHashMap<>();
  private final LongSupplier nanos;

  /**
   * @param walls of the floor that the robot is on; empty: it is on none any more
   * @param nanos when it was heard
   */
  private record Heard(
      List<Double> metres, List<Double> angles, Supplier<Optional<Walls>> walls, long nanos) {}

  /**
   * @param nanos now, on a monotonic clock
   */
  PublishedRanges(LongSupplier nanos) {
    this.nanos = nanos;
  }

  /**
   * Takes what a robot has published.
   *
   * @param angles as many as ranges
   * @param walls of the floor that it is on, for whoever takes these
   */
  void put(
      String robot, List<Double> metres, List<Double> angles, Supplier<Optional<Walls>> walls) {
    AtomicReference<@Nullable Heard> own = newest.get(robot);
    if (own != null) {
      own.set(new Heard(metres, angles, walls, nanos.getAsLong()));
    }
  }

  /** Those of one robot, from now on. */
  RangeSource of(String robot) {
    AtomicReference<@Nullable Heard> own =
        newest.computeIfAbsent(robot, _ -> new AtomicReference<>());
    return () -> take(own);
  }

  private Optional<RangeSource.Measured> take(AtomicReference<@Nullable Heard> own) {
    Heard heard = own.getAndSet(null);
    return heard == null || nanos.getAsLong() - heard.nanos() > FRESH_NANOS
        ? Optional.empty()
        : heard
            .walls()
            .get()
            .map(walls -> new RangeSource.Measured(heard.metres(), heard.angles(), walls));
  }
}
