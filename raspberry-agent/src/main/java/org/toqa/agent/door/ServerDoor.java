package org.toqa.agent.door;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Waits for servers that connect; its thread does nothing else. */
final class ServerDoor implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(ServerDoor.class);

  private final String robot;
  private final ServerSocket socket;
  private final Threshold threshold;

  ServerDoor(String robot, InetAddress address, int port, Threshold threshold) throws IOException {
    this.robot = robot;
    this.threshold = threshold;
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
    Thread.ofVirtual().name(robot + "-door").start(this::accept);
  }

  int port() {
    return socket.getLocalPort();
  }

  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("{}: closing the door failed.", robot, e);
    }
    threshold.close();
  }

  private void accept() {
    while (!socket.isClosed()) {
      try {
        Socket client = socket.accept();
        client.setTcpNoDelay(true);
        client.setKeepAlive(true);
        threshold.receive(client);
      } catch (IOException e) {
        if (!socket.isClosed()) {
          log.warn("{}: a connection could not be taken: {}", robot, e.getMessage());
        }
      }
    }
  }
}
