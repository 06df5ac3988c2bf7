package org.toqa.app.command;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * The request to stop, from Ctrl-C, a system that shuts down, or a part without which the work
 * cannot go on. The process goes on until the work is closed, but for no longer than ten seconds.
 */
public final class StopSignal implements AutoCloseable {
  private static final int CLOSE_TIMEOUT_SECONDS = 10;

  /** Closing has limits of its own; together they are less. */
  private static final int FAILED_CLOSE_TIMEOUT_SECONDS = 60;

  private final CountDownLatch requested = new CountDownLatch(1);
  private final CountDownLatch closed = new CountDownLatch(1);
  private final AtomicBoolean hasFailed = new AtomicBoolean();

  public StopSignal() {
    Runtime.getRuntime().addShutdownHook(new Thread(this::requestStop, "stop"));
  }

  private void requestStop() {
    requested.countDown();
    try {
      if (!closed.await(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
        System.err.println(
            "toqa: did not end within " + CLOSE_TIMEOUT_SECONDS + " s; stopped anyway.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Something has failed without which the work cannot go on: the process is to stop, and ends hard
   * where the work does not let itself be closed.
   *
   * @param reason for a person
   */
  public void fail(String reason) {
    if (hasFailed.compareAndSet(false, true)) {
      System.err.println("toqa: " + reason);
      Thread.ofPlatform().daemon().name("end").start(this::endHard);
      requested.countDown();
    }
  }

  private void endHard() {
    try {
      if (!closed.await(FAILED_CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
        Runtime.getRuntime().halt(1);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether the request came by {@link #fail}. */
  public boolean hasFailed() {
    return hasFailed.get();
  }

  /** Whether the process was asked to stop. */
  public boolean isRequested() {
    return requested.getCount() == 0;
  }

  /** Waits until the process is asked to stop. */
  public void await() throws InterruptedException {
    requested.await();
  }

  /** Everything is closed: the process may end. */
  @Override
  public void close() {
    closed.countDown();
  }
}
