package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class MeasuredServerTest {
  private static final int DELAY = 300;

  private final AtomicInteger asked = new AtomicInteger();
  private final long begun = System.nanoTime();
  private HttpServer server;
  private Process process;

  @BeforeEach
  void start() throws IOException {
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    process = new ProcessBuilder("sleep", "60").start();
  }

  @AfterEach
  void end() {
    process.destroyForcibly();
    server.stop(0);
  }

  /** It answers 503 until it can work: that is no start yet. */
  @Test
  void startUpEndsWithTheFirstAnswer200() throws Exception {
    server.createContext(
        "/api/v1/health",
        exchange -> {
          boolean isUp = asked.incrementAndGet() > 3;
          if (isUp) {
            LockSupport.parkNanos(DELAY * 1_000_000L);
          }
          exchange.sendResponseHeaders(isUp ? 200 : 503, -1);
          exchange.close();
        });
    server.start();

    double millis = MeasuredServer.awaitHealth(health(), begun, process);

    double until = (System.nanoTime() - begun) / 1e6;
    assertTrue(millis >= 0.99 * DELAY && millis <= until, () -> millis + " of " + until + " ms");
    assertEquals(4, asked.get());
  }

  @Test
  void serverThatEndsIsNotWaitedFor() throws Exception {
    URI nobody = health();
    server.stop(0);
    Process ended = new ProcessBuilder("sh", "-c", "exit 3").start();
    assertEquals(3, ended.waitFor());

    IOException failure =
        assertThrows(IOException.class, () -> MeasuredServer.awaitHealth(nobody, begun, ended));

    assertEquals("The server ended before it was healthy, with 3.", failure.getMessage());
  }

  private URI health() {
    return URI.create("http://127.0.0.1:" + server.getAddress().getPort() + "/api/v1/health");
  }
}
