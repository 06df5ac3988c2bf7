package org.toqa.fleet;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Writes what agents change to the store, in order, on a thread of its own, and tells when each
 * change is safe.
 *
 * <p>What has come while others were being stored goes into one transaction, so that a commit is
 * paid once for many. While the store does not answer, that transaction is tried again and all
 * others wait: the commands that follow from them are not sent, so the robots finish what they have
 * and stop. If one of its changes can never be stored, each is stored by itself, and that one is
 * left out and told.
 */
public final class StoreWriter implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(StoreWriter.class);
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(2);

  /** In one transaction, so that it ends soon and keeps few others from their rows. */
  static final int MOST_TOGETHER = 64;

  private final String name;
  private final ExecutorService thread;
  private final Consumer<Runnable> transaction;
  private final Consumer<Sentence> onLeftOut;
  private final Queue<Change> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicReference<@Nullable String> trouble = new AtomicReference<>();

  /**
   * @param part whose change it is, as people know it
   * @param isTriedOnce stored by itself, since its caller waits for the answer
   */
  private record Change(
      String part,
      Runnable work,
      Runnable stored,
      Consumer<StoreException> failed,
      boolean isTriedOnce) {}

  /**
   * @param transaction does all that the work given to it asks of the store in one transaction, as
   *     {@link FleetStore#inOneTransaction}
   * @param onLeftOut is told, on the writer's thread, of each change that can never be stored
   */
  public StoreWriter(
      String name,
      FleetRuntime runtime,
      Consumer<Runnable> transaction,
      Consumer<Sentence> onLeftOut) {
    this.name = name;
    this.thread = runtime.serialExecutor("store-" + name);
    this.transaction = transaction;
    this.onLeftOut = onLeftOut;
  }

  /**
   * @param change asks the store, and does nothing else that must not be done twice
   * @param stored called on the writer's thread once the change is safe
   */
  public void write(Runnable change, Runnable stored) {
    write(change, stored, refusal -> {});
  }

  /**
   * @param change asks the store, and does nothing else that must not be done twice
   * @param stored called on the writer's thread once the change is safe
   * @param refused called there instead when it can never be stored
   */
  public void write(Runnable change, Runnable stored, Consumer<StoreException> refused) {
    write(name, change, stored, refused);
  }

  /**
   * As the other one, in the name of a part of what this writes for.
   *
   * @param part such as a robot; who reads that the change was left out reads its name
   */
  public void write(
      String part, Runnable change, Runnable stored, Consumer<StoreException> refused) {
    add(new Change(part, change, stored, refused, false));
  }

  /**
   * Tries a change once; for orders whose caller waits for the answer.
   *
   * @param failed gets the sentence when it could not be stored
   */
  public void tryOnce(Runnable change, Runnable stored, Consumer<StoreException> failed) {
    add(new Change(name, change, stored, failed, true));
  }

  private void add(Change change) {
    waiting.add(change);
    thread.execute(this::storeWaiting);
  }

  /** Nothing, where what was to be stored went with what came before it. */
  private void storeWaiting() {
    List<Change> together = takeTogether();
    if (together.isEmpty()) {
      return;
    }
    if (together.size() == 1) {
      storeAlone(together.getFirst());
      return;
    }
    try {
      boolean isStored =
          retryUntilStored(
              () -> transaction.accept(() -> together.forEach(change -> change.work().run())));
      if (isStored) {
        together.forEach(StoreWriter::tellStored);
      }
    } catch (StoreException e) {
      log.info("{}: {} changes are stored one by one: {}", name, together.size(), e.getMessage());
      together.forEach(this::storeAlone);
    }
  }

  private List<Change> takeTogether() {
    List<Change> together = new ArrayList<>();
    Change next = waiting.peek();
    while (next != null
        && together.size() < MOST_TOGETHER
        && (together.isEmpty() || !next.isTriedOnce())) {
      together.add(next);
      waiting.remove();
      next = next.isTriedOnce() ? null : waiting.peek();
    }
    return together;
  }

  private void storeAlone(Change change) {
    try {
      if (change.isTriedOnce()) {
        tryNow(change.work());
        tellStored(change);
      } else if (retryUntilStored(change.work())) {
        tellStored(change);
      }
    } catch (StoreException e) {
      if (change.isTriedOnce()) {
        log.warn("The store refused a change.", e);
      } else {
        leaveOut(change, e);
      }
      change.failed().accept(e);
    }
  }

  /** What goes wrong with that is no reason to keep it from others. */
  private static void tellStored(Change change) {
    try {
      change.stored().run();
    } catch (RuntimeException e) {
      log.error("{}: what follows from a stored change failed.", change.part(), e);
    }
  }

  private void leaveOut(Change change, StoreException refusal) {
    log.error("{}: a change can never be stored, and is left out.", change.part(), refusal);
    trouble.set(null);
    onLeftOut.accept(
        Phrase.CHANGE_LEFT_OUT.with(change.part(), String.valueOf(refusal.getMessage())));
  }

  /** Why the store does not answer, or null while it does. */
  @Nullable
  public String trouble() {
    return trouble.get();
  }

  /**
   * @throws StoreException it was not stored
   */
  private static void tryNow(Runnable change) {
    try {
      change.run();
    } catch (RuntimeException e) {
      throw StoreException.of(e);
    }
  }

  /**
   * @throws StoreException it can never be stored
   */
  private boolean retryUntilStored(Runnable change) {
    Duration pause = Duration.ofMillis(50);
    while (true) {
      try {
        tryNow(change);
        trouble.set(null);
        return true;
      } catch (StoreException e) {
        if (e.isRefusal()) {
          throw e;
        }
        log.warn(
            "The store does not answer; trying again in {} ms: {}",
            pause.toMillis(),
            e.getMessage());
        trouble.set(e.getMessage());
      }
      try {
        Thread.sleep(pause);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return false;
      }
      pause =
          pause.multipliedBy(2).compareTo(LONGEST_PAUSE) < 0
              ? pause.multipliedBy(2)
              : LONGEST_PAUSE;
    }
  }

  /** Lets what was handed in be written, for a while; then gives up. */
  @Override
  public void close() {
    thread.shutdown();
    try {
      if (!thread.awaitTermination(3, TimeUnit.SECONDS)) {
        thread.shutdownNow();
      }
    } catch (InterruptedException e) {
      thread.shutdownNow();
      Thread.currentThread().interrupt();
    }
  }
}
