package org.toqa.link.channel;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Takes the TCP connections of a port until it is closed; its thread does nothing else. */
public final class ConnectionListener implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(ConnectionListener.class);

  private static final Duration PAUSE_AFTER_FAILURE = Duration.ofMillis(100);

  private final String name;
  private final ServerSocket socket;
  private final Receiver receiver;

  /** Gets each connection; it may not wait. */
  public interface Receiver {
    /** Closes it before it throws. */
    void receive(Socket client) throws IOException;
  }

  /**
   * Listens from now on; what connects waits for {@link #start}.
   *
   * @param name of who listens, for logs
   * @throws IOException if it cannot
   */
  public ConnectionListener(String name, InetSocketAddress address, Receiver receiver)
      throws IOException {
    this.name = name;
    this.receiver = receiver;
    socket = new ServerSocket();
    try {
      socket.setReuseAddress(true);
      socket.bind(address);
    } catch (IOException e) {
      socket.close();
      throw e;
    }
  }

  /** Takes connections from now on; called once. */
  public void start() {
    Thread.ofVirtual().name(name + "-listener").start(this::receiveConnections);
  }

  /** Of TCP. */
  public int port() {
    return socket.getLocalPort();
  }

  public boolean isClosed() {
    return socket.isClosed();
  }

  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("{}: closing the listener failed.", name, e);
    }
  }

  private void receiveConnections() {
    while (!socket.isClosed()) {
      try {
        receiver.receive(socket.accept());
      } catch (IOException e) {
        if (!socket.isClosed()) {
          log.warn("{}: a connection could not be taken: {}", name, e.getMessage());
          pause();
        }
      }
    }
  }

  private static void pause() {
    try {
      Thread.sleep(PAUSE_AFTER_FAILURE); // as when there are too many open files
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
