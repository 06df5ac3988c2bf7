package org.toqa.fleet;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.mission.TransportTask;

/**
 * Stores new tasks so that their askers hear the truth: a task that was accepted is stored, and one
 * that was not is not stored later, when nobody waits for it any more.
 *
 * <p>All that came in during one transaction go into the next one together (group commit), so that
 * many askers wait hardly longer than one.
 */
final class TaskIntake {
  /** Shorter than any asker waits for the answer. */
  private static final Duration LIMIT = Duration.ofSeconds(8);

  private static final int MOST_AT_ONCE = 100;

  private final FleetStore store;
  private final StoreWriter writer;
  private final BlockingQueue<Entry> waiting = new LinkedBlockingQueue<>();

  /**
   * @param deadline of {@link System#nanoTime}
   */
  private record Entry(
      Submission submission, long deadline, Consumer<TransportTask> accepted, Runnable refused) {
    boolean isInTime() {
      return System.nanoTime() - deadline <= 0;
    }
  }

  TaskIntake(FleetStore store, StoreWriter writer) {
    this.store = store;
    this.writer = writer;
  }

  /**
   * Stores the task, in time or not at all.
   *
   * @param key names the wish; no stored task has it
   * @param accepted gets the task with its id, on the writer's thread
   * @param refused called there when it was not stored
   */
  void take(TransportTask task, UUID key, Consumer<TransportTask> accepted, Runnable refused) {
    waiting.add(
        new Entry(
            new Submission(task, key), System.nanoTime() + LIMIT.toNanos(), accepted, refused));
    List<Entry> group = new ArrayList<>();
    writer.tryOnce(() -> store(group), () -> {}, failure -> group.forEach(this::refuse));
  }

  /**
   * @param group gets those that go into one transaction; none where an earlier one took them all
   */
  private void store(List<Entry> group) {
    waiting.drainTo(group, MOST_AT_ONCE);
    List<Entry> late = group.stream().filter(entry -> !entry.isInTime()).toList();
    late.forEach(this::refuse);
    group.removeAll(late);
    if (group.isEmpty()) {
      return;
    }
    List<TransportTask> stored = store.addTasks(group.stream().map(Entry::submission).toList());
    for (int i = 0; i < group.size(); i++) {
      if (group.get(i).isInTime()) {
        group.get(i).accepted().accept(stored.get(i));
      } else {
        refuse(group.get(i));
      }
    }
  }

  private void refuse(Entry entry) {
    writer.write(() -> store.withdraw(entry.submission().key()), () -> {});
    entry.refused().run();
  }
}
