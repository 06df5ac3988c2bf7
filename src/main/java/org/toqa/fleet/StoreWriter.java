package org.toqa.fleet;

import java.time.Duration;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.persistence.StoreException;

/**
 * Writes an agent's changes to the store, in order, on a thread of its own, and tells when each is
 * safe. While the store does not answer, the oldest change is tried again and all others wait: the
 * commands that follow from them are not sent, so the robots finish what they have and stop.
 */
public final class StoreWriter implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(StoreWriter.class);
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(2);

  private final ExecutorService thread;
  private final AtomicReference<@Nullable String> trouble = new AtomicReference<>();

  public StoreWriter(String name, FleetRuntime runtime) {
    thread = runtime.serialExecutor("store-" + name);
  }

  /**
   * @param change one transaction
   * @param stored called on the writer's thread once the change is safe
   */
  public void write(Runnable change, Runnable stored) {
    thread.execute(
        () -> {
          if (retryUntilStored(change)) {
            stored.run();
          }
        });
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
            change.run();
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

  private boolean retryUntilStored(Runnable change) {
    Duration pause = Duration.ofMillis(50);
    while (true) {
      try {
        change.run();
        trouble.set(null);
        return true;
      } catch (StoreException e) {
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
