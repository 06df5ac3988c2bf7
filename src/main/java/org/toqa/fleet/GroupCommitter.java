package org.toqa.fleet;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.WaitingChanges.Change;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Stores the changes of many agents on a thread of its own. All that came in during one transaction
 * go into the next one together (group commit): many wait hardly longer than one, and the store
 * makes one commit for all of them.
 *
 * <ol>
 *   <li>An agent writes by a {@link StoreWriter} of its own, whose changes stay in order.
 *   <li>While the store does not answer, the same group is tried again and all others wait: the
 *       commands that follow from them are not sent, so the robots finish what they have and stop.
 *   <li>Where one fails and the store answers, those before it, it alone, and those after it are
 *       stored one after the other. If it can never be stored it is left out and told; else it is
 *       tried again from time to time, and the later ones of its writer wait for it.
 * </ol>
 */
public final class GroupCommitter implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(GroupCommitter.class);
  private static final Duration SHORTEST_PAUSE = Duration.ofMillis(50);
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(2);
  private static final int CLOSE_SECONDS = 3;

  /** Of the time, one that fails for long takes at most one part of so many from the others. */
  private static final int RETRY_SHARE = 4;

  private final String name;
  private final FleetStore store;
  private final ExecutorService thread;
  private final Consumer<Sentence> onLeftOut;
  private final Duration shortestPause;
  private final WaitingChanges waiting = new WaitingChanges(this::schedule);
  private volatile @Nullable String trouble;

  /** Of the changes that are tried again while others are stored; of the writer's thread alone. */
  private Duration retryPause;

  private long retryAt;

  /**
   * @param index of the change that failed; -1: none was begun; their number: the commit failed
   */
  private record Failure(int index, StoreException why) {}

  /**
   * @param onLeftOut is told, on any thread, of what was left out
   */
  public GroupCommitter(
      String name, FleetStore store, FleetRuntime runtime, Consumer<Sentence> onLeftOut) {
    this(name, store, runtime, onLeftOut, SHORTEST_PAUSE);
  }

  /**
   * @param shortestPause until what failed is tried again first
   */
  GroupCommitter(
      String name,
      FleetStore store,
      FleetRuntime runtime,
      Consumer<Sentence> onLeftOut,
      Duration shortestPause) {
    this.name = name;
    this.store = store;
    this.thread = runtime.serialExecutor("store-" + name);
    this.onLeftOut = onLeftOut;
    this.shortestPause = shortestPause;
    this.retryPause = shortestPause;
  }

  /** For changes that are nobody's else. */
  public StoreWriter writer() {
    return writer(name);
  }

  /**
   * @param agent whose changes they are
   */
  public StoreWriter writer(String agent) {
    return new StoreWriter(agent, waiting, this);
  }

  /** Why the store does not answer, or null while it does. */
  @Nullable String trouble() {
    return trouble;
  }

  private void schedule() {
    thread.execute(this::storeWaiting);
  }

  private void storeWaiting() {
    try {
      while (!waiting.rest()) {
        retryFailed();
        List<Change> group = waiting.takeGroup();
        if (!group.isEmpty()) {
          store(group);
        } else if (!waiting.failed().isEmpty()) {
          waiting.await(Duration.ofNanos(retryAt - System.nanoTime()));
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      waiting.abandon();
    } catch (Throwable e) { // or nothing would ever be stored again
      waiting.abandon();
      throw e;
    }
  }

  private void store(List<Change> group) throws InterruptedException {
    Failure failure = tryStore(group);
    for (Duration pause = shortestPause;
        failure != null && isStoreAway(failure, group) && !group.getFirst().isTriedOnce();
        pause = longer(pause)) {
      log.warn(
          "The store does not answer; trying again in {} ms: {}",
          pause.toMillis(),
          failure.why().getMessage());
      trouble = failure.why().getMessage();
      Thread.sleep(pause);
      failure = tryStore(group);
    }
    if (failure == null) {
      group.forEach(this::tellStored);
      endTrouble();
    } else if (group.size() == 1) {
      settle(group.getFirst(), failure.why());
    } else {
      int failed = Math.clamp(failure.index(), 0, group.size() - 1);
      storeUnfailed(group.subList(0, failed));
      storeUnfailed(group.subList(failed, failed + 1));
      storeUnfailed(group.subList(failed + 1, group.size()));
    }
  }

  private void storeUnfailed(List<Change> part) throws InterruptedException {
    List<Change> group = waiting.keepUnfailed(part);
    if (!group.isEmpty()) {
      store(group);
    }
  }

  /**
   * @return null: all of them are stored
   */
  private @Nullable Failure tryStore(List<Change> group) {
    int[] begun = {-1};
    try {
      if (group.size() == 1) {
        begun[0] = 0;
        group.getFirst().run();
      } else {
        store.saveTogether(
            () -> {
              for (begun[0] = 0; begun[0] < group.size(); begun[0]++) {
                group.get(begun[0]).run();
              }
            });
      }
      return null;
    } catch (StoreException e) {
      return new Failure(begun[0], e);
    }
  }

  /** Whether it would fail all others too, now. */
  private boolean isStoreAway(Failure failure, List<Change> group) {
    if (failure.why().isRefusal()) {
      return false;
    }
    if (failure.index() < 0 || failure.index() == group.size()) {
      return true;
    }
    try {
      store.checkAvailable();
      return false;
    } catch (StoreException e) {
      return true;
    }
  }

  /** What becomes of one that was tried alone, while the store answers. */
  private void settle(Change change, StoreException why) {
    if (change.isTriedOnce()) {
      log.warn("The store refused a change.", why);
      tellFailed(change, why);
    } else if (why.isRefusal()) {
      log.error("{}: a change can never be stored, and is left out.", change.writer(), why);
      tellLeftOut(Phrase.CHANGE_LEFT_OUT.with(change.writer(), String.valueOf(why.getMessage())));
      tellFailed(change, why);
      endTrouble();
    } else {
      log.warn("{}: a change is not stored, and is tried again.", change.writer(), why);
      trouble = why.getMessage();
      waiting.addFailed(change);
      retryPause = shortestPause;
      retryAt = System.nanoTime() + retryPause.toNanos();
    }
  }

  private void retryFailed() {
    List<Change> failed = waiting.failed();
    if (failed.isEmpty() || retryAt - System.nanoTime() > 0) {
      return;
    }
    long begin = System.nanoTime();
    for (Change change : failed) {
      Failure failure = tryStore(List.of(change));
      if (failure == null) {
        waiting.removeFailed(change);
        tellStored(change);
        endTrouble();
      } else if (failure.why().isRefusal()) {
        waiting.removeFailed(change);
        settle(change, failure.why());
      }
    }
    retryPause = longer(retryPause);
    long end = System.nanoTime();
    retryAt = end + Math.max(retryPause.toNanos(), (RETRY_SHARE - 1) * (end - begin));
  }

  private void endTrouble() {
    if (waiting.failed().isEmpty()) {
      trouble = null;
    }
  }

  void tellLeftOut(Sentence what) {
    onLeftOut.accept(what);
  }

  private void tellStored(Change change) {
    tell(change, change::tellStored);
  }

  private void tellFailed(Change change, StoreException why) {
    tell(change, () -> change.tellFailed(why));
  }

  /** Who cannot be told keeps nobody else from it. */
  private static void tell(Change change, Runnable listener) {
    try {
      listener.run();
    } catch (RuntimeException e) {
      log.error("{}: what follows from a change failed.", change.writer(), e);
    }
  }

  private static Duration longer(Duration pause) {
    Duration longer = pause.multipliedBy(2);
    return longer.compareTo(LONGEST_PAUSE) < 0 ? longer : LONGEST_PAUSE;
  }

  /** Lets what was handed in be stored, for a while; then gives up. */
  @Override
  public void close() {
    thread.shutdown();
    try {
      if (!thread.awaitTermination(CLOSE_SECONDS, TimeUnit.SECONDS)) {
        thread.shutdownNow();
      }
    } catch (InterruptedException e) {
      thread.shutdownNow();
      Thread.currentThread().interrupt();
    }
  }
}
