package org.toqa.fleet.manager;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.NegotiationEntry;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskView;
import org.toqa.wording.Sentence;

/**
 * The snapshots of all floors put together, for readers on any thread. They are put together when
 * one is asked for, so that floors that change often cost nothing that nobody looks at.
 */
final class SiteSnapshots implements SnapshotFeed {
  private final Supplier<List<SnapshotFeed>> floors;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition renewed = lock.newCondition();

  /** Rises with every change; guarded by the lock. */
  private long version;

  /** What concerns all floors; guarded by the lock. */
  private List<Sentence> alerts = List.of();

  private @Nullable Hold pause;

  /** The last one that was put together. */
  private volatile FleetSnapshot latest;

  /**
   * @param floors in their order; asked by readers
   */
  SiteSnapshots(Instant at, @Nullable Hold pause, Supplier<List<SnapshotFeed>> floors) {
    this.floors = floors;
    this.pause = pause;
    this.latest = FleetSnapshot.initial(at, pause);
  }

  /** Something of a floor has changed, or which floors there are. */
  void renew() {
    lock.lock();
    try {
      version++;
      renewed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  void setPause(@Nullable Hold next) {
    lock.lock();
    try {
      pause = next;
      renew();
    } finally {
      lock.unlock();
    }
  }

  void setAlerts(List<Sentence> next) {
    lock.lock();
    try {
      if (!alerts.equals(next)) {
        alerts = List.copyOf(next);
        renew();
      }
    } finally {
      lock.unlock();
    }
  }

  @Override
  public FleetSnapshot latest() {
    lock.lock();
    try {
      if (latest.version() < version) {
        latest = merge();
      }
      return latest;
    } finally {
      lock.unlock();
    }
  }

  private FleetSnapshot merge() {
    List<FleetSnapshot> parts = floors.get().stream().map(SnapshotFeed::latest).toList();
    List<RobotView> robots = new ArrayList<>();
    List<TaskView> tasks = new ArrayList<>();
    List<FloorView> views = new ArrayList<>();
    Map<Long, List<NegotiationEntry>> negotiations = new HashMap<>();
    Map<String, String> allocators = new HashMap<>();
    Set<Sentence> told = new LinkedHashSet<>(alerts);
    Instant at = latest.at();
    int queued = 0;
    for (FleetSnapshot part : parts) {
      robots.addAll(part.robots());
      tasks.addAll(part.tasks());
      views.addAll(part.floors());
      negotiations.putAll(part.negotiations());
      allocators.putAll(part.allocators());
      told.addAll(part.alerts());
      queued += part.queuedCount();
      at = part.at().isAfter(at) ? part.at() : at;
    }
    robots.sort(Comparator.comparing(RobotView::name));
    tasks.sort(Comparator.comparingLong(TaskView::id).reversed());
    return new FleetSnapshot(
        version,
        at,
        robots,
        tasks,
        queued,
        views,
        pause,
        negotiations,
        allocators,
        List.copyOf(told));
  }

  @Override
  public FleetSnapshot awaitNewer(long seen, Duration limit) throws InterruptedException {
    lock.lock();
    try {
      long left = limit.toNanos();
      while (version <= seen && left > 0) {
        left = renewed.awaitNanos(left);
      }
    } finally {
      lock.unlock();
    }
    return latest();
  }
}
