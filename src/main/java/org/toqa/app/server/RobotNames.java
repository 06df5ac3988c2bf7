package org.toqa.app.server;

import java.time.Duration;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;

/**
 * Whether a site has a robot of a name, as of half a second ago at most: it is asked for each
 * message that comes. Any thread may ask.
 */
final class RobotNames implements Predicate<String> {
  private static final Duration KNOWN_FOR = Duration.ofMillis(500);

  private final SnapshotFeed feed;
  private volatile Known known;

  /**
   * @param since of the monotonic clock, nanoseconds
   */
  private record Known(Set<String> names, long since) {}

  RobotNames(SnapshotFeed feed) {
    this.feed = feed;
    this.known = now();
  }

  private Known now() {
    return new Known(
        feed.latest().robots().stream().map(RobotView::name).collect(Collectors.toSet()),
        System.nanoTime());
  }

  @Override
  public boolean test(String name) {
    Known newest = known;
    if (System.nanoTime() - newest.since() >= KNOWN_FOR.toNanos()) {
      newest = now();
      known = newest;
    }
    return newest.names().contains(name);
  }
}
