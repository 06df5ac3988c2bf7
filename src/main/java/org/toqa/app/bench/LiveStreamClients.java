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
import java.time.InstantSource;
import java.util.concurrent.atomic.AtomicLong;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Programs that watch live: each reads and parses every event, and looks for the poses in it. */
final class LiveStreamClients implements AutoCloseable {
  private static final int BUFFER_BYTES = 64 * 1024;
  private static final String DATA_PREFIX = "data: ";

  private final HttpClient http = HttpClient.newHttpClient();
  private final AtomicLong events = new AtomicLong();
  private final PoseLatencies latencies;
  private final InstantSource clock;

  private LiveStreamClients(PoseLatencies latencies, InstantSource clock) {
    this.latencies = latencies;
    this.clock = clock;
  }

  /**
   * @param root where the pages are, with a slash at its end
   * @param count how many watch
   * @param latencies gets what they see
   * @param clock that of the server and of the robots' reports
   * @throws IOException the server does not answer, or refuses a stream
   */
  static LiveStreamClients open(
      URI root, String token, int count, PoseLatencies latencies, InstantSource clock)
      throws IOException, InterruptedException {
    LiveStreamClients clients = new LiveStreamClients(latencies, clock);
    HttpRequest request =
        HttpRequest.newBuilder(root.resolve("api/v1/events?changes=true"))
            .header("Authorization", "Bearer " + token)
            .build();
    for (int i = 0; i < count; i++) {
      HttpResponse<InputStream> stream = clients.http.send(request, BodyHandlers.ofInputStream());
      if (stream.statusCode() != 200) {
        throw new IOException("A live stream was answered by " + stream.statusCode() + ".");
      }
      Thread.ofVirtual().name("reader").start(() -> clients.read(stream.body()));
    }
    return clients;
  }

  private void read(InputStream stream) {
    PoseLatencies.Watcher watcher = latencies.new Watcher();
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8), BUFFER_BYTES)) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (line.startsWith(DATA_PREFIX)) {
          JsonNode event = JsonMapper.shared().readTree(line.substring(DATA_PREFIX.length()));
          watcher.receive(event, clock.instant());
          events.incrementAndGet();
        }
      }
    } catch (IOException closed) {
      // the stream was closed
    }
  }

  /** Discards what was counted so far. */
  void reset() {
    events.set(0);
  }

  /** How many events all of them have received together. */
  long events() {
    return events.get();
  }

  @Override
  public void close() {
    http.shutdownNow();
  }
}
