package org.toqa.link.trust;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * Closes a socket that is not done in time, however slowly the other end feeds it; whoever reads it
 * is thrown out. Nothing happens once this is closed.
 */
public final class TimeLimit implements AutoCloseable {

  private final Socket socket;
  private final CompletableFuture<Void> alarm;
  private volatile boolean passed;

  public TimeLimit(Socket socket, Duration limit) {
    this.socket = socket;
    alarm =
        CompletableFuture.runAsync(
            this::strike,
            CompletableFuture.delayedExecutor(
                limit.toMillis(), TimeUnit.MILLISECONDS, Thread::startVirtualThread));
  }

  /** Whether the socket was closed for it. */
  public boolean hasPassed() {
    return passed;
  }

  @Override
  public void close() {
    alarm.cancel(false);
  }

  private void strike() {
    passed = true;
    try {
      socket.close();
    } catch (IOException e) {
      throw new IllegalStateException("A socket could not be closed.", e);
    }
  }
}
