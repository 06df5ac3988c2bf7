package org.toqa.fleet;

import java.time.Duration;

/**
 * The newest {@link FleetSnapshot}, for any number of readers. A slow reader skips, nothing queues
 * for it, and it slows nobody.
 */
public interface SnapshotFeed {

  FleetSnapshot latest();

  /**
   * Waits until there is a snapshot with a version above {@code version}, or until {@code limit}
   * has passed, and answers the newest one in either case. Called by a virtual thread of the
   * reader.
   */
  FleetSnapshot awaitNewer(long version, Duration limit) throws InterruptedException;
}
