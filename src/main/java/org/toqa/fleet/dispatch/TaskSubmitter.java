package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.StoreWriter;
import org.toqa.mission.TransportTask;
import org.toqa.persistence.StoreException;

/**
 * Stores new tasks so that their callers are told the truth: a task that was accepted stays stored,
 * and one that was not is not stored later, when nobody waits for it any more. What was perhaps
 * stored is withdrawn; until that is done its key is pending, and accepted by nobody. Of tasks that
 * are wanted together all are stored or none.
 *
 * <p>All that came in during one transaction go into the next one together (group commit), so that
 * many callers wait hardly longer than one. Any thread may bring tasks.
 */
public final class TaskSubmitter {
  private static final Logger log = LoggerFactory.getLogger(TaskSubmitter.class);

  /** Shorter than any caller waits for the answer. */
  private static final Duration LIMIT = Duration.ofSeconds(8);

  private static final int MOST_AT_ONCE = 100;

  private final FleetStore store;
  private final StoreWriter writer;
  private final PendingSubmissions pending;
  private final LongSupplier nanoTime;
  private final BlockingQueue<Entry> waiting = new LinkedBlockingQueue<>();

  /**
   * @param submissions what is wanted together
   * @param deadline of {@link #deadline}
   */
  private record Entry(
      List<Submission> submissions,
      long deadline,
      Consumer<List<TransportTask>> onAccepted,
      Consumer<StoreException> onRejected) {
    List<UUID> keys() {
      return submissions.stream().map(Submission::idempotencyKey).toList();
    }
  }

  /**
   * @param nanoTime of {@link #deadline}
   */
  public TaskSubmitter(
      FleetStore store, StoreWriter writer, PendingSubmissions pending, LongSupplier nanoTime) {
    this.store = store;
    this.writer = writer;
    this.pending = pending;
    this.nanoTime = nanoTime;
  }

  /**
   * Until when what is asked for now must be stored.
   *
   * @param nanoTime of the moment when it was asked for
   */
  public static long deadline(long nanoTime) {
    return nanoTime + LIMIT.toNanos();
  }

  private boolean isInTime(Entry entry) {
    return nanoTime.getAsLong() - entry.deadline() <= 0;
  }

  /**
   * Stores the tasks, in time or not at all.
   *
   * @param submissions no stored task has a key of theirs
   * @param deadline of {@link #deadline}
   * @param accepted gets the tasks with their ids, on the writer's thread
   * @param refused called, with the reason, when they were not stored, or are there only until they
   *     are withdrawn
   */
  public void submit(
      List<Submission> submissions,
      long deadline,
      Consumer<List<TransportTask>> accepted,
      Consumer<StoreException> refused) {
    Entry added = new Entry(submissions, deadline, accepted, refused);
    if (!pending.begin(added.keys())) {
      refused.accept(beingStored());
      return;
    }
    waiting.add(added);
    List<Entry> undecided = new ArrayList<>();
    writer.tryOnce(
        () -> store(undecided),
        () -> {},
        failure -> undecided.forEach(entry -> withdraw(entry, failure)));
  }

  /**
   * @param undecided gets those that go into one transaction, none where an earlier one took them
   *     all; who was given an answer leaves it, also where this fails on another one after him
   */
  private void store(List<Entry> undecided) {
    waiting.drainTo(undecided, MOST_AT_ONCE);
    for (Entry entry : List.copyOf(undecided)) {
      if (!isInTime(entry)) {
        undecided.remove(entry);
        refuse(entry, tooLate());
      }
    }
    if (undecided.isEmpty()) {
      return;
    }
    try {
      add(List.copyOf(undecided), undecided);
    } catch (StoreException e) {
      if (!e.isRefusal() || undecided.size() == 1) {
        throw e;
      }
      List.copyOf(undecided).forEach(entry -> storeAlone(entry, undecided)); // one refuses no other
    }
  }

  private void storeAlone(Entry entry, List<Entry> undecided) {
    try {
      add(List.of(entry), undecided);
    } catch (StoreException e) {
      undecided.remove(entry);
      withdraw(entry, e);
    }
  }

  private void add(List<Entry> group, List<Entry> undecided) {
    List<TransportTask> stored = addTasks(group);
    int told = 0;
    for (Entry entry : group) {
      int next = told + entry.submissions().size();
      undecided.remove(entry);
      if (isInTime(entry)) {
        pending.end(entry.keys());
        tell(entry, stored.subList(told, next));
      } else {
        withdraw(entry, tooLate());
      }
      told = next;
    }
  }

  private static void tell(Entry entry, List<TransportTask> stored) {
    try {
      entry.onAccepted().accept(stored);
    } catch (RuntimeException e) {
      log.error("Tasks {} are stored, but who asked for them failed on it.", entry.keys(), e);
    }
  }

  private List<TransportTask> addTasks(List<Entry> group) {
    try {
      return store.addTasks(group.stream().flatMap(e -> e.submissions().stream()).toList());
    } catch (RuntimeException e) {
      throw StoreException.of(e);
    }
  }

  /** It was never handed to the store. */
  private void refuse(Entry entry, StoreException why) {
    pending.end(entry.keys());
    entry.onRejected().accept(why);
  }

  /** It is stored, or may be. */
  private void withdraw(Entry entry, StoreException why) {
    writer.write(() -> store.withdrawTasks(entry.keys()), () -> pending.end(entry.keys()));
    entry.onRejected().accept(why);
  }

  private static StoreException tooLate() {
    return new StoreException("The database did not answer in time.", null);
  }

  private static StoreException beingStored() {
    return new StoreException("What was sent with this key is being stored.", null);
  }
}
