package org.toqa.fleet.manager;

import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.wording.Sentence;

/** Where the manager agent puts the newest snapshot, and readers on other threads find it. */
final class LatestSnapshot implements SnapshotFeed {
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition renewed = lock.newCondition();
  private volatile FleetSnapshot latest;

  /** As the agents published it, guarded by the lock. */
  private FleetSnapshot published;

  /** What others found, before the agents' own alerts; guarded by the lock. */
  private List<Sentence> found = List.of();

  LatestSnapshot(FleetSnapshot first) {
    latest = first;
    published = first;
  }

  /** Its version becomes the next one. */
  void publish(FleetSnapshot snapshot) {
    lock.lock();
    try {
      published = snapshot;
      renew();
    } finally {
      lock.unlock();
    }
  }

  /** Puts these alerts on the newest snapshot and on all that follow, instead of those before. */
  void setAlerts(List<Sentence> alerts) {
    lock.lock();
    try {
      if (!found.equals(alerts)) {
        found = List.copyOf(alerts);
        renew();
      }
    } finally {
      lock.unlock();
    }
  }

  private void renew() {
    Set<Sentence> alerts = new LinkedHashSet<>(found);
    alerts.addAll(published.alerts());
    latest = published.with(latest.version() + 1, List.copyOf(alerts));
    renewed.signalAll();
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
