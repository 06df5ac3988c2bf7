package org.toqa.app;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * The wish to end, from Ctrl-C or a system that shuts down. The process lives on until the work is
 * closed, but no longer than ten seconds.
 */
final class StopSignal implements AutoCloseable {
  private static final int SECONDS_TO_CLOSE = 10;

  private final CountDownLatch wished = new CountDownLatch(1);
  private final CountDownLatch closed = new CountDownLatch(1);

  StopSignal() {
    Runtime.getRuntime().addShutdownHook(new Thread(this::stop, "stop"));
  }

  private void stop() {
    wished.countDown();
    try {
      if (!closed.await(SECONDS_TO_CLOSE, TimeUnit.SECONDS)) {
        System.err.println("toqa: did not end within " + SECONDS_TO_CLOSE + " s; stopped anyway.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  boolean isWished() {
    return wished.getCount() == 0;
  }

  void await() throws InterruptedException {
    wished.await();
  }

  /** Everything is closed: the process may end. */
  @Override
  public void close() {
    closed.countDown();
  }
}
