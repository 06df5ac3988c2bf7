package org.toqa.agent.connection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.link.trust.LinkSocket;

@Timeout(60)
class PeerConnectionTest {
  private static final int LIMIT_MS = 10_000;

  @Test
  void connectionWhoseReadingFailsHasEnded() throws IOException {
    CountDownLatch onward = new CountDownLatch(1);
    try (ServerSocket port = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        Socket peer = new Socket(port.getInetAddress(), port.getLocalPort());
        PeerConnection connection =
            new PeerConnection(
                "r1",
                LinkSocket.plain(port.accept()),
                _ -> {
                  onward.await();
                  throw new IllegalStateException("on purpose");
                })) {
      peer.setSoTimeout(LIMIT_MS);
      connection.start();
      assertNull(connection.endReason());
      onward.countDown();
      assertEquals(-1, peer.getInputStream().read());
      assertEquals("reading it failed", connection.endReason());
    }
  }
}
