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
  private final CompletableFuture<Void> timer;
  private volatile boolean hasPassed;

  /**
   * @param limit of real time, from now on; to the millisecond
   */
  public TimeLimit(Socket socket, Duration limit) {
    this.socket = socket;
    timer =
        CompletableFuture.runAsync(
            this::closeSocket,
            CompletableFuture.delayedExecutor(
                limit.toMillis(), TimeUnit.MILLISECONDS, Thread::startVirtualThread));
  }

  /** Whether the socket was closed for it. */
  public boolean hasPassed() {
    return hasPassed;
  }

  @Override
  public void close() {
    timer.cancel(false);
  }

  private void closeSocket() {
    hasPassed = true;
    try {
      socket.close();
    } catch (IOException e) {
      throw new IllegalStateException("A socket could not be closed.", e);
    }
  }
}
