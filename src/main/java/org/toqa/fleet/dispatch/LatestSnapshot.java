package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.wording.Sentence;

/** Where the dispatch puts the floor's newest snapshot, and readers on other threads find it. */
public final class LatestSnapshot implements SnapshotFeed {
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition renewed = lock.newCondition();
  private volatile FleetSnapshot latest;

  /** As the agents published it, guarded by the lock. */
  private FleetSnapshot published;

  /** What others found, before the agents' own alerts; guarded by the lock. */
  private List<Sentence> found = List.of();

  /** The same of robots, by name, where the agents have none; guarded by the lock. */
  private Map<String, Sentence> foundOfRobots = Map.of();

  /** Those that a supervisor knows of; guarded by the lock. */
  private List<BoxView> boxes = List.of();

  private final Runnable onRenewed;

  /**
   * @param onRenewed is told, by the thread that publishes, of each newer one
   */
  public LatestSnapshot(FleetSnapshot first, Runnable onRenewed) {
    this.onRenewed = onRenewed;
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
    onRenewed.run();
  }

  /**
   * Puts these alerts on the newest snapshot and on all that follow, instead of those before.
   *
   * @param ofRobots by name; the agents' own come before them
   */
  public void setAlerts(List<Sentence> alerts, Map<String, Sentence> ofRobots) {
    lock.lock();
    try {
      if (found.equals(alerts) && foundOfRobots.equals(ofRobots)) {
        return;
      }
      found = List.copyOf(alerts);
      foundOfRobots = Map.copyOf(ofRobots);
      renew();
    } finally {
      lock.unlock();
    }
    onRenewed.run();
  }

  /** Puts these boxes on the newest snapshot and on all that follow, instead of those before. */
  public void setBoxes(List<BoxView> next) {
    lock.lock();
    try {
      if (boxes.equals(next)) {
        return;
      }
      boxes = List.copyOf(next);
      renew();
    } finally {
      lock.unlock();
    }
    onRenewed.run();
  }

  private void renew() {
    Set<Sentence> alerts = new LinkedHashSet<>(found);
    alerts.addAll(published.alerts());
    FleetSnapshot next = published.with(latest.version() + 1, List.copyOf(alerts));
    if (!foundOfRobots.isEmpty()) {
      next = next.withRobots(withAlerts(next.robots()));
    }
    if (!boxes.isEmpty()) {
      next = next.withFloors(next.floors().stream().map(view -> view.withBoxes(boxes)).toList());
    }
    latest = next;
    renewed.signalAll();
  }

  private List<RobotView> withAlerts(List<RobotView> robots) {
    return robots.stream()
        .map(
            robot ->
                robot.alert() == null ? robot.withAlert(foundOfRobots.get(robot.name())) : robot)
        .toList();
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
