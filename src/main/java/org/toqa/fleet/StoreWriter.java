package org.toqa.fleet;

import java.time.Duration;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Writes an agent's changes to the store, in order, on a thread of its own, and tells when each is
 * safe. While the store does not answer, the oldest change is tried again and all others wait: the
 * commands that follow from them are not sent, so the robots finish what they have and stop. A
 * change that can never be stored is left out and told, and the next one comes.
 */
public final class StoreWriter implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(StoreWriter.class);
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(2);

  private final String name;
  private final ExecutorService thread;
  private final Consumer<Sentence> onLeftOut;
  private final AtomicReference<@Nullable String> trouble = new AtomicReference<>();

  /**
   * @param onLeftOut is told, on the writer's thread, of each change that can never be stored
   */
  public StoreWriter(String name, FleetRuntime runtime, Consumer<Sentence> onLeftOut) {
    this.name = name;
    this.thread = runtime.serialExecutor("store-" + name);
    this.onLeftOut = onLeftOut;
  }

  /**
   * @param change one transaction
   * @param stored called on the writer's thread once the change is safe
   */
  public void write(Runnable change, Runnable stored) {
    write(change, stored, refusal -> {});
  }

  /**
   * @param change one transaction
   * @param stored called on the writer's thread once the change is safe
   * @param refused called there instead when it can never be stored
   */
  public void write(Runnable change, Runnable stored, Consumer<StoreException> refused) {
    thread.execute(
        () -> {
          try {
            if (retryUntilStored(change)) {
              stored.run();
            }
          } catch (StoreException refusal) {
            leaveOut(refusal);
            refused.accept(refusal);
          }
        });
  }

  private void leaveOut(StoreException refusal) {
    log.error("{}: a change can never be stored, and is left out.", name, refusal);
    trouble.set(null);
    onLeftOut.accept(Phrase.CHANGE_LEFT_OUT.with(name, String.valueOf(refusal.getMessage())));
  }

  /**
   * Tries a change once; for orders whose caller waits for the answer.
   *
   * @param failed gets the sentence when it could not be stored
   */
  public void tryOnce(Runnable change, Runnable stored, Consumer<StoreException> failed) {
    thread.execute(
        () -> {
          try {
            tryNow(change);
          } catch (StoreException e) {
            log.warn("The store refused a change.", e);
            failed.accept(e);
            return;
          }
          stored.run();
        });
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
      if (!thread.awaitTermination(3, java.util.concurrent.TimeUnit.SECONDS)) {
        thread.shutdownNow();
      }
    } catch (InterruptedException e) {
      thread.shutdownNow();
      Thread.currentThread().interrupt();
    }
  }
}
