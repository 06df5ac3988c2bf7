package org.toqa.app.bench;

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
 * Browsers that watch live. All read everything; one in twenty parses it, since the readers share
 * the machine with the server that they measure.
 */
final class LiveStreamClients implements AutoCloseable {
  private static final int PARSING_INTERVAL = 20;
  private static final int BUFFER_BYTES = 64 * 1024;
  private static final String DATA_PREFIX = "data: ";

  private final HttpClient http = HttpClient.newHttpClient();
  private final Queue<Double> poseAgeMillis = new ConcurrentLinkedQueue<>();
  private final AtomicLong events = new AtomicLong();
  private final InstantSource clock;

  private LiveStreamClients(InstantSource clock) {
    this.clock = clock;
  }

  /**
   * @param root where the pages are, with a slash at its end
   * @param count how many watch
   * @param clock that of the server
   * @throws IOException the server does not answer, or refuses a stream
   */
  static LiveStreamClients open(URI root, String token, int count, InstantSource clock)
      throws IOException, InterruptedException {
    LiveStreamClients clients = new LiveStreamClients(clock);
    HttpRequest request =
        HttpRequest.newBuilder(root.resolve("api/v1/events?changes=true"))
            .header("Authorization", "Bearer " + token)
            .build();
    for (int i = 0; i < count; i++) {
      HttpResponse<InputStream> stream = clients.http.send(request, BodyHandlers.ofInputStream());
      if (stream.statusCode() != 200) {
        throw new IOException("A live stream was answered by " + stream.statusCode() + ".");
      }
      boolean parses = i % PARSING_INTERVAL == 0;
      Thread.ofVirtual().name("reader").start(() -> clients.read(stream.body(), parses));
    }
    return clients;
  }

  private void read(InputStream stream, boolean parses) {
    try (stream) {
      if (parses) {
        parse(stream);
      } else {
        count(stream);
      }
    } catch (IOException closed) {
      // the stream was closed
    }
  }

  /** An event ends with an empty line: two line feeds. */
  private void count(InputStream stream) throws IOException {
    byte[] buffer = new byte[BUFFER_BYTES];
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

  private void parse(InputStream stream) throws IOException {
    Map<String, String> last = new HashMap<>();
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8), BUFFER_BYTES);
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      if (line.startsWith(DATA_PREFIX)) {
        Instant now = clock.instant();
        events.incrementAndGet();
        recordPoseAges(
            JsonMapper.shared().readTree(line.substring(DATA_PREFIX.length())), last, now);
      }
    }
  }

  /** A robot that was heard of since the last event. */
  private void recordPoseAges(JsonNode event, Map<String, String> last, Instant now) {
    List<Double> ages = new ArrayList<>();
    for (JsonNode robot : event.path("robots")) {
      String seen = robot.path("lastSeen").asString("");
      if (!seen.isEmpty() && !seen.equals(last.put(robot.get("name").asString(), seen))) {
        ages.add(Duration.between(Instant.parse(seen), now).toNanos() / 1e6);
      }
    }
    poseAgeMillis.addAll(ages);
  }

  /** Discards what was measured so far. */
  void reset() {
    poseAgeMillis.clear();
    events.set(0);
  }

  /** From when the server heard of a robot until a browser had the event, milliseconds. */
  double[] poseAgeMillis() {
    return poseAgeMillis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** How many events all browsers have received together. */
  long events() {
    return events.get();
  }

  @Override
  public void close() {
    http.shutdownNow();
  }
}
