package org.toqa.telemetry.mqtt;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.testbed.Hall;

/** Snapshots as a test sets them. */
final class FeedInMemory implements SnapshotFeed {
  private FleetSnapshot latest = FleetSnapshot.initial(Hall.START, null);

  static RobotView robot(String name, RobotState state) {
    return Hall.robot(name, state, new Pose(1, 1, 0), "127.0.0.1", 7275);
  }

  synchronized void set(List<RobotView> robots, List<TaskView> tasks) {
    latest =
        new FleetSnapshot(
            latest.version() + 1,
            Hall.START,
            robots,
            tasks,
            0,
            List.of(),
            null,
            Map.of(),
            Map.of(),
            List.of());
    notifyAll();
  }

  @Override
  public synchronized FleetSnapshot latest() {
    return latest;
  }

  @Override
  public synchronized FleetSnapshot awaitNewer(long version, Duration limit)
      throws InterruptedException {
    long end = System.nanoTime() + limit.toNanos();
    while (latest.version() <= version && System.nanoTime() < end) {
      wait(Math.max(1, (end - System.nanoTime()) / 1_000_000));
    }
    return latest;
  }
}
