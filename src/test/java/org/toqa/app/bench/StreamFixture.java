package org.toqa.app.bench;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.toqa.geometry.Pose;

/** A server of one robot, whose live stream is late by as much as a test wants. */
final class StreamFixture implements AutoCloseable {
  private static final int REPORT_MILLIS = 300;

  private final HttpServer server;
  private final PoseReports reports;
  private final Duration beforeHearing;
  private final Duration beforeSending;

  /**
   * @param beforeHearing from the robot's report until this server hears it
   * @param beforeSending from there until the event is sent
   * @param page what it serves as its map
   */
  StreamFixture(PoseReports reports, Duration beforeHearing, Duration beforeSending, String page)
      throws IOException {
    this.reports = reports;
    this.beforeHearing = beforeHearing;
    this.beforeSending = beforeSending;
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.setExecutor(Executors.newVirtualThreadPerTaskExecutor());
    server.createContext("/api/v1/events", this::stream);
    server.createContext("/map", exchange -> answer(exchange, page));
    server.start();
  }

  URI root() {
    return URI.create("http://127.0.0.1:" + server.getAddress().getPort() + "/");
  }

  private void stream(HttpExchange exchange) throws IOException {
    exchange.getResponseHeaders().set("Content-Type", "text/event-stream");
    exchange.sendResponseHeaders(200, 0);
    String robot = "r" + Thread.currentThread().threadId(); // each stream has its own
    try (OutputStream out = exchange.getResponseBody()) {
      for (int i = 0; ; i++) {
        Pose pose = new Pose(0.1 * i, 1.0 / 3, 0.7);
        reports.add(robot, pose);
        TimeUnit.NANOSECONDS.sleep(beforeHearing.toNanos());
        Instant heard = Instant.now();
        TimeUnit.NANOSECONDS.sleep(beforeSending.toNanos());
        String event =
            """
            event: change
            data: {"robots":[{"name":"%s","pose":{"x":%s,"y":%s,"theta":%s},"lastSeen":"%s"}]}

            """
                .formatted(robot, pose.x(), pose.y(), pose.theta(), heard);
        out.write(event.getBytes(StandardCharsets.UTF_8));
        out.flush();
        TimeUnit.MILLISECONDS.sleep(REPORT_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void answer(HttpExchange exchange, String page) throws IOException {
    byte[] bytes = page.getBytes(StandardCharsets.UTF_8);
    exchange.getResponseHeaders().set("Content-Type", "text/html");
    exchange.sendResponseHeaders(200, bytes.length);
    exchange.getResponseBody().write(bytes);
    exchange.close();
  }

  @Override
  public void close() {
    server.stop(0);
  }
}
