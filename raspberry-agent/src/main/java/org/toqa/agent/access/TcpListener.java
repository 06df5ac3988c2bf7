package org.toqa.agent.access;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Waits for servers that connect; its thread does nothing else. */
final class TcpListener implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(TcpListener.class);

  private static final Duration PAUSE_AFTER_FAILURE = Duration.ofMillis(100);

  private final String robot;
  private final ServerSocket socket;
  private final ConnectionAcceptor acceptor;

  TcpListener(String robot, InetAddress address, int port, ConnectionAcceptor acceptor)
      throws IOException {
    this.robot = robot;
    this.acceptor = acceptor;
    socket = new ServerSocket();
    try {
      socket.setReuseAddress(true);
      socket.bind(new InetSocketAddress(address, port));
    } catch (IOException e) {
      socket.close();
      throw new IOException(
          "Port %d on %s cannot be listened on (%s); is another daemon running there?"
              .formatted(port, address.getHostAddress(), e.getMessage()),
          e);
    }
    Thread.ofVirtual().name(robot + "-listener").start(this::acceptConnections);
  }

  int port() {
    return socket.getLocalPort();
  }

  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("{}: closing the listener failed.", robot, e);
    }
    acceptor.close();
  }

  private void acceptConnections() {
    while (!socket.isClosed()) {
      try {
        take(socket.accept());
      } catch (IOException e) {
        if (!socket.isClosed()) {
          log.warn("{}: a connection could not be taken: {}", robot, e.getMessage());
          pause();
        }
      }
    }
  }

  private void take(Socket client) throws IOException {
    try {
      client.setTcpNoDelay(true);
      client.setKeepAlive(true);
    } catch (IOException e) {
      client.close();
      throw e;
    }
    acceptor.accept(client);
  }

  private static void pause() {
    try {
      Thread.sleep(PAUSE_AFTER_FAILURE); // as when there are too many open files
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
