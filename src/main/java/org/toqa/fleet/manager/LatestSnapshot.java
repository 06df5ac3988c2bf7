package org.toqa.fleet.manager;

import java.time.Duration;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.SnapshotFeed;

/** Where the manager agent puts the newest snapshot, and readers on other threads find it. */
final class LatestSnapshot implements SnapshotFeed {
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition renewed = lock.newCondition();
  private volatile FleetSnapshot latest;

  LatestSnapshot(FleetSnapshot first) {
    latest = first;
  }

  void publish(FleetSnapshot snapshot) {
    lock.lock();
    try {
      latest = snapshot;
      renewed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public FleetSnapshot latest() {
    return latest;
  }

  @Override
  public FleetSnapshot awaitNewer(long version, Duration limit) throws InterruptedException {
    lock.lock();
    try {
      long left = limit.toNanos();
      while (latest.version() <= version && left > 0) {
        left = renewed.awaitNanos(left);
      }
      return latest;
    } finally {
      lock.unlock();
    }
  }
}
