package org.toqa.app.command;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * The request to stop, from Ctrl-C or a system that shuts down. The process goes on until the work
 * is closed, but for no longer than ten seconds.
 */
public final class StopSignal implements AutoCloseable {
  private static final int CLOSE_TIMEOUT_SECONDS = 10;

  private final CountDownLatch requested = new CountDownLatch(1);
  private final CountDownLatch closed = new CountDownLatch(1);

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
