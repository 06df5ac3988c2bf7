package org.toqa.fleet;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Work that is done again and again on a thread of its own, with a pause after each time. What is
 * running when it is closed is waited for and never interrupted: an embedded database closes its
 * file when a thread that reads it is interrupted.
 */
public final class PeriodicWork implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(PeriodicWork.class);
  private static final Duration END_LIMIT = Duration.ofSeconds(5);

  private final String name;
  private final ScheduledExecutorService thread;

  /**
   * @param pause also before the first time
   */
  public PeriodicWork(String name, Duration pause, Runnable work) {
    this.name = name;
    thread =
        Executors.newSingleThreadScheduledExecutor(
            Thread.ofPlatform().daemon().name(name).factory());
    var _ =
        thread.scheduleWithFixedDelay(
            () -> runOnce(work), pause.toNanos(), pause.toNanos(), TimeUnit.NANOSECONDS);
  }

  /** A surprise does not end it, nor does an error that the next time may not have. */
  private void runOnce(Runnable work) {
    try {
      work.run();
    } catch (RuntimeException | Error e) {
      log.error("{} failed; it is tried again.", name, e);
    }
  }

  @Override
  public void close() {
    thread.shutdown();
    try {
      if (!thread.awaitTermination(END_LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
        log.warn("{} does not end.", name);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
