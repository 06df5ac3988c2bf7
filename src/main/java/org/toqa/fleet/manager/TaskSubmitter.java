package org.toqa.fleet.manager;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.StoreWriter;
import org.toqa.mission.TransportTask;
import org.toqa.persistence.StoreException;

/**
 * Stores new tasks so that their callers are told the truth: a task that was accepted is stored,
 * and one that was not is not stored later, when nobody waits for it any more. Of tasks that are
 * wanted together all are stored or none.
 *
 * <p>All that came in during one transaction go into the next one together (group commit), so that
 * many callers wait hardly longer than one. Any thread may bring tasks.
 */
final class TaskSubmitter {
  /** Shorter than any caller waits for the answer. */
  private static final Duration LIMIT = Duration.ofSeconds(8);

  private static final int MOST_AT_ONCE = 100;

  private final FleetStore store;
  private final StoreWriter writer;
  private final BlockingQueue<Entry> waiting = new LinkedBlockingQueue<>();

  /**
   * @param submissions what is wanted together
   * @param deadline of {@link System#nanoTime}
   */
  private record Entry(
      List<Submission> submissions,
      long deadline,
      Consumer<List<TransportTask>> onAccepted,
      Consumer<StoreException> onRejected) {
    boolean isInTime() {
      return System.nanoTime() - deadline <= 0;
    }
  }

  TaskSubmitter(FleetStore store, StoreWriter writer) {
    this.store = store;
    this.writer = writer;
  }

  /** Until when what is asked for now must be stored; of {@link System#nanoTime}. */
  static long deadline() {
    return System.nanoTime() + LIMIT.toNanos();
  }

  /**
   * Stores the tasks, in time or not at all.
   *
   * @param submissions no stored task has a key of theirs
   * @param deadline when they were asked for, {@link #deadline} told it
   * @param accepted gets the tasks with their ids, on the writer's thread
   * @param refused called there, with the reason, when they were not stored
   */
  void submit(
      List<Submission> submissions,
      long deadline,
      Consumer<List<TransportTask>> accepted,
      Consumer<StoreException> refused) {
    waiting.add(new Entry(submissions, deadline, accepted, refused));
    List<Entry> group = new ArrayList<>();
    writer.tryOnce(
        () -> store(group), () -> {}, failure -> group.forEach(entry -> reject(entry, failure)));
  }

  /**
   * @param group gets those that go into one transaction; none where an earlier one took them all
   */
  private void store(List<Entry> group) {
    waiting.drainTo(group, MOST_AT_ONCE);
    List<Entry> late = group.stream().filter(entry -> !entry.isInTime()).toList();
    late.forEach(entry -> reject(entry, tooLate()));
    group.removeAll(late);
    if (group.isEmpty()) {
      return;
    }
    try {
      add(group);
    } catch (StoreException e) {
      if (!e.isRefusal() || group.size() == 1) {
        throw e;
      }
      group.forEach(this::storeAlone); // one of them refuses no other
    }
  }

  private void storeAlone(Entry entry) {
    try {
      add(List.of(entry));
    } catch (StoreException e) {
      reject(entry, e);
    }
  }

  private void add(List<Entry> group) {
    List<TransportTask> stored =
        store.addTasks(group.stream().flatMap(entry -> entry.submissions().stream()).toList());
    int told = 0;
    for (Entry entry : group) {
      int next = told + entry.submissions().size();
      if (entry.isInTime()) {
        entry.onAccepted().accept(stored.subList(told, next));
      } else {
        reject(entry, tooLate());
      }
      told = next;
    }
  }

  private static StoreException tooLate() {
    return new StoreException("The database did not answer in time.", null);
  }

  private void reject(Entry entry, StoreException why) {
    List<UUID> keys = entry.submissions().stream().map(Submission::idempotencyKey).toList();
    writer.write(() -> store.withdrawTasks(keys), () -> {});
    entry.onRejected().accept(why);
  }
}
