package org.toqa.fleet;

import java.time.Duration;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** Where the manager agent hangs the newest snapshot, and readers on other threads find it. */
final class SnapshotBoard implements SnapshotFeed {
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition renewed = lock.newCondition();
  private volatile FleetSnapshot latest;

  SnapshotBoard(FleetSnapshot first) {
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
