package org.toqa.fleet;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.persistence.StoreException;

/**
 * Changes that wait for the store. Agents add them, one thread takes them. Those of one writer stay
 * in order: while one of them is to be tried again, the later ones wait for it.
 */
final class WaitingChanges {
  /** So many go into one transaction. */
  private static final int MOST_AT_ONCE = 200;

  /** What may be left out is not added to so many. */
  private static final int MOST_WAITING = 10_000;

  /** Has them taken; called while this is locked. */
  private final Runnable schedule;

  /** In the order in which they came. */
  private final TreeSet<Change> waiting =
      new TreeSet<>(Comparator.comparingLong((Change change) -> change.number));

  private long lastNumber;

  /** Those that wait and are of interest only until the next one comes. */
  private final Map<Subject, Change> newest = new HashMap<>();

  /** By their writers, those that are to be tried again. */
  private final Map<String, Change> failed = new LinkedHashMap<>();

  private boolean isScheduled;

  private record Subject(String writer, String name) {}

  /** A change and who is told of it; each is one of its own, whatever is in it. */
  static final class Change {
    private final String writer;
    private final @Nullable Subject subject;
    private final boolean isTriedOnce;
    private final Runnable work;
    private final Runnable onStored;
    private final Consumer<StoreException> onFailed;

    /** Of its turn. */
    private long number;

    /**
     * @param subject null: it is stored whatever comes after it
     * @param isTriedOnce alone, and not again
     */
    Change(
        String writer,
        @Nullable String subject,
        boolean isTriedOnce,
        Runnable work,
        Runnable onStored,
        Consumer<StoreException> onFailed) {
      this.writer = writer;
      this.subject = subject == null ? null : new Subject(writer, subject);
      this.isTriedOnce = isTriedOnce;
      this.work = work;
      this.onStored = onStored;
      this.onFailed = onFailed;
    }

    String writer() {
      return writer;
    }

    boolean isTriedOnce() {
      return isTriedOnce;
    }

    /**
     * A fault of this program in a change is one that comes again each time.
     *
     * @throws StoreException it was not stored
     */
    void run() {
      try {
        work.run();
      } catch (StoreException e) {
        throw e;
      } catch (RuntimeException e) {
        throw new StoreException(StoreException.Kind.REFUSED, String.valueOf(e), e);
      }
    }

    void tellStored() {
      onStored.run();
    }

    void tellFailed(StoreException why) {
      onFailed.accept(why);
    }
  }

  /**
   * @param schedule has {@link #takeGroup} called until it is empty, and then {@link #rest}
   */
  WaitingChanges(Runnable schedule) {
    this.schedule = schedule;
  }

  synchronized void add(Change change) {
    if (!isScheduled) {
      schedule.run();
      isScheduled = true;
    }
    change.number = ++lastNumber;
    if (change.subject != null) {
      Change older = newest.put(change.subject, change);
      if (older != null) {
        waiting.remove(older);
      }
    }
    waiting.add(change);
    notifyAll();
  }

  synchronized boolean isFull() {
    return waiting.size() >= MOST_WAITING;
  }

  /**
   * Takes the oldest ones that may be stored together.
   *
   * @return empty: there are none, but perhaps some that wait for another one
   */
  synchronized List<Change> takeGroup() {
    List<Change> group = new ArrayList<>();
    for (Change change : waiting) {
      if (failed.containsKey(change.writer)) {
        continue;
      }
      if (group.size() == MOST_AT_ONCE || (change.isTriedOnce && !group.isEmpty())) {
        break;
      }
      group.add(change);
      if (change.isTriedOnce) {
        break;
      }
    }
    group.forEach(this::remove);
    return group;
  }

  private void remove(Change change) {
    waiting.remove(change);
    if (change.subject != null) {
      newest.remove(change.subject, change);
    }
  }

  /** Those of a group that need not wait for another one; the others wait on. */
  synchronized List<Change> keepUnfailed(List<Change> group) {
    for (Change change : group) {
      if (failed.containsKey(change.writer)
          && (change.subject == null || newest.putIfAbsent(change.subject, change) == null)) {
        waiting.add(change);
      }
    }
    return group.stream().filter(change -> !failed.containsKey(change.writer)).toList();
  }

  /** It is to be tried again. */
  synchronized void addFailed(Change change) {
    failed.put(change.writer, change);
  }

  synchronized List<Change> failed() {
    return List.copyOf(failed.values());
  }

  /** It is settled, and those that wait for it may go on. */
  synchronized void removeFailed(Change change) {
    failed.remove(change.writer, change);
  }

  /** Waits for another one, for so long at most. */
  synchronized void await(Duration limit) throws InterruptedException {
    if (!limit.isNegative() && !limit.isZero()) {
      TimeUnit.NANOSECONDS.timedWait(this, limit.toNanos());
    }
  }

  /** Whether there is nothing to do any more; from then on, who adds a change has it taken anew. */
  synchronized boolean rest() {
    if (waiting.isEmpty() && failed.isEmpty()) {
      isScheduled = false;
    }
    return !isScheduled;
  }

  /** Who took them does so no more: who adds the next one has all taken anew. */
  synchronized void abandon() {
    isScheduled = false;
  }
}
