package org.toqa.app;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Browsers that watch live. All read everything; one in twenty looks into it, since the readers
 * share the machine with the server that they measure.
 */
final class LiveReaders implements AutoCloseable {
  private static final int ONE_LOOKS_OF = 20;
  private static final int BUFFER = 64 * 1024;
  private static final String DATA = "data: ";

  private final HttpClient http = HttpClient.newHttpClient();
  private final Queue<Double> millis = new ConcurrentLinkedQueue<>();
  private final AtomicLong events = new AtomicLong();
  private final InstantSource clock;

  private LiveReaders(InstantSource clock) {
    this.clock = clock;
  }

  static LiveReaders open(URI root, String token, int count, InstantSource clock)
      throws IOException, InterruptedException {
    LiveReaders readers = new LiveReaders(clock);
    HttpRequest request =
        HttpRequest.newBuilder(root.resolve("api/v1/events?changes=true"))
            .header("Authorization", "Bearer " + token)
            .build();
    for (int i = 0; i < count; i++) {
      HttpResponse<InputStream> stream = readers.http.send(request, BodyHandlers.ofInputStream());
      if (stream.statusCode() != 200) {
        throw new IOException("A live stream was answered by " + stream.statusCode() + ".");
      }
      boolean looks = i % ONE_LOOKS_OF == 0;
      Thread.ofVirtual().name("reader").start(() -> readers.read(stream.body(), looks));
    }
    return readers;
  }

  private void read(InputStream stream, boolean looks) {
    try (stream) {
      if (looks) {
        look(stream);
      } else {
        drain(stream);
      }
    } catch (IOException theEnd) {
      // the stream was closed
    }
  }

  /** An event ends with an empty line: two line feeds. */
  private void drain(InputStream stream) throws IOException {
    byte[] buffer = new byte[BUFFER];
    boolean wasLineFeed = false;
    for (int count = stream.read(buffer); count >= 0; count = stream.read(buffer)) {
      for (int i = 0; i < count; i++) {
        boolean isLineFeed = buffer[i] == '\n';
        if (isLineFeed && wasLineFeed) {
          events.incrementAndGet();
        }
        wasLineFeed = isLineFeed;
      }
    }
  }

  private void look(InputStream stream) throws IOException {
    Map<String, String> last = new HashMap<>();
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8), BUFFER);
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      if (line.startsWith(DATA)) {
        Instant now = clock.instant();
        events.incrementAndGet();
        note(JsonMapper.shared().readTree(line.substring(DATA.length())), last, now);
      }
    }
  }

  /** A robot that was heard of since the last event. */
  private void note(JsonNode event, Map<String, String> last, Instant now) {
    List<Double> ages = new ArrayList<>();
    for (JsonNode robot : event.path("robots")) {
      String seen = robot.path("lastSeen").asString("");
      if (!seen.isEmpty() && !seen.equals(last.put(robot.get("name").asString(), seen))) {
        ages.add(Duration.between(Instant.parse(seen), now).toNanos() / 1e6);
      }
    }
    millis.addAll(ages);
  }

  /** What was measured so far does not count. */
  void forget() {
    millis.clear();
    events.set(0);
  }

  double[] millis() {
    return millis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  long events() {
    return events.get();
  }

  @Override
  public void close() {
    http.shutdownNow();
  }
}
