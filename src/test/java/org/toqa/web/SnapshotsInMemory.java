package org.toqa.web;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskView;
import org.toqa.grid.CellRuns;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Snapshots that a test publishes: robots, the floor, alerts and pauses as it sets them. */
public abstract class SnapshotsInMemory implements SnapshotFeed {
  final List<TaskView> tasks = new ArrayList<>();
  final ReentrantLock lock = new ReentrantLock();
  final Condition withChange = lock.newCondition();
  FleetSnapshot latest =
      new FleetSnapshot(
          1, Hall.START, List.of(), List.of(), 0, List.of(), null, Map.of(), Map.of(), List.of());
  List<FloorView> floors = List.of();
  Map<String, String> allocators = Map.of();
  List<Sentence> alerts = List.of();
  List<Sentence> failures = List.of();
  List<Sentence> advice = List.of();
  @Nullable Hold pause;

  /** Publishes why the fleet cannot go on, as the agents do: also among the alerts. */
  public void setFailure(Sentence failure) {
    lock.lock();
    try {
      failures = List.of(failure);
      alerts = failures;
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  /** Publishes what ails the whole fleet. */
  public void setAdvice(Sentence advice) {
    lock.lock();
    try {
      this.advice = List.of(advice);
    } finally {
      lock.unlock();
    }
  }

  public void setAlert(String alert) {
    setAlert(Sentence.verbatim(alert));
  }

  public void setAlert(Sentence alert) {
    lock.lock();
    try {
      alerts = List.of(alert);
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  /** Publishes these robots and no others. */
  public void setRobots(RobotView... robots) {
    changeRobots(before -> List.of(robots));
  }

  /** Publishes other robots. */
  public void changeRobots(UnaryOperator<List<RobotView>> change) {
    lock.lock();
    try {
      publish(change.apply(latest.robots()));
    } finally {
      lock.unlock();
    }
  }

  /** Publishes what is in the way on the floor. */
  public void changeFloor(FloorView view) {
    lock.lock();
    try {
      floors = List.of(view);
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  /** To be called with the lock. */
  void forgetSnapshot() {
    floors = List.of();
    alerts = List.of();
    failures = List.of();
    pause = null;
    publish(List.of());
  }

  CompletionStage<Answer<Optional<Hold>>> setPause(@Nullable Hold next) {
    lock.lock();
    try {
      pause = next;
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(Optional.ofNullable(next)));
    } finally {
      lock.unlock();
    }
  }

  Answer<Optional<String>> chooseAllocator(String floor, Optional<String> allocator) {
    lock.lock();
    try {
      if (!floor.equals("hall")) {
        return new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(floor));
      }
      allocators = allocator.map(word -> Map.of(floor, word)).orElse(Map.of());
      publish(latest.robots());
      return new Answer.Accepted<>(allocator);
    } finally {
      lock.unlock();
    }
  }

  CompletionStage<Answer<Optional<Hold>>> setFloorHold(String floor, @Nullable Hold next) {
    lock.lock();
    try {
      if (!floor.equals("hall")) {
        return CompletableFuture.completedFuture(
            new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(floor)));
      }
      floors =
          List.of(
              Views.floor(
                  floor, next, CellRuns.NONE, Map.of(), List.of(), List.of(), List.of(), null));
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(Optional.ofNullable(next)));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public FleetSnapshot latest() {
    lock.lock();
    try {
      return latest;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public FleetSnapshot awaitNewer(long version, Duration limit) throws InterruptedException {
    lock.lock();
    try {
      long left = limit.toNanos();
      while (latest.version() <= version && left > 0) {
        left = withChange.awaitNanos(left);
      }
      return latest;
    } finally {
      lock.unlock();
    }
  }

  void publish(List<RobotView> robots) {
    latest =
        new FleetSnapshot(
            latest.version() + 1,
            latest.at().plusMillis(200),
            robots,
            newestFirst(),
            (int) tasks.stream().filter(t -> t.state() == TaskState.QUEUED).count(),
            floors,
            pause,
            Map.of(),
            allocators,
            alerts);
    withChange.signalAll();
  }

  List<TaskView> newestFirst() {
    List<TaskView> copy = new ArrayList<>(tasks);
    Collections.reverse(copy);
    return copy;
  }
}
