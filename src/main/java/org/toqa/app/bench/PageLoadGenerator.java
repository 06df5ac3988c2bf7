package org.toqa.app.bench;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * People who open one page after another, at a fixed rate whether or not the earlier ones have
 * come: a page is timed from when it was due, so that a server that stalls does not look faster
 * than it is.
 */
final class PageLoadGenerator implements AutoCloseable {
  private static final List<String> PAGES =
      List.of(
          "map",
          "tasks",
          "robots",
          "robots/r1",
          "tasks/new",
          "statistics",
          "history",
          "api/v1/robots",
          "api/v1/tasks",
          "api/v1/robots/r2");

  private static final Duration TIMEOUT = Duration.ofSeconds(30);

  private final HttpClient http = HttpClient.newHttpClient();
  private final Queue<Double> latencyMillis = new ConcurrentLinkedQueue<>();
  private final AtomicInteger failed = new AtomicInteger();
  private final URI root;
  private final String token;
  private final long nanosBetween;
  private final Thread requestThread;

  private PageLoadGenerator(URI root, String token, int rate) {
    this.root = root;
    this.token = token;
    this.nanosBetween = Duration.ofSeconds(1).toNanos() / rate;
    this.requestThread = Thread.ofPlatform().name("visitors").daemon().start(this::run);
  }

  /**
   * @param root where the pages are, with a slash at its end
   * @param rate pages a second
   */
  static PageLoadGenerator start(URI root, String token, int rate) {
    return new PageLoadGenerator(root, token, rate);
  }

  private void run() {
    long due = System.nanoTime();
    for (int n = 0; !Thread.currentThread().isInterrupted(); n++) {
      due += nanosBetween;
      while (System.nanoTime() < due && !Thread.currentThread().isInterrupted()) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      String page = PAGES.get(n % PAGES.size());
      long begun = due;
      Thread.ofVirtual().name("visitor").start(() -> request(page, begun));
    }
  }

  private void request(String page, long due) {
    HttpRequest request =
        HttpRequest.newBuilder(root.resolve(page))
            .header("Authorization", "Bearer " + token)
            .timeout(TIMEOUT)
            .build();
    try {
      int status = http.send(request, BodyHandlers.ofByteArray()).statusCode();
      failed.addAndGet(status == 200 ? 0 : 1);
      latencyMillis.add((System.nanoTime() - due) / 1e6);
    } catch (IOException e) {
      failed.incrementAndGet();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Discards what was measured so far. */
  void reset() {
    latencyMillis.clear();
    failed.set(0);
  }

  /** From when each page was due until it was there, milliseconds. */
  double[] latencyMillis() {
    return latencyMillis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** How many pages were not answered with status 200. */
  int failed() {
    return failed.get();
  }

  @Override
  public void close() {
    requestThread.interrupt();
    http.shutdownNow();
  }
}
