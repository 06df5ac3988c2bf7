package org.toqa.testbed;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import java.util.stream.Stream;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A user of the API, logged in. */
public final class ApiClient implements AutoCloseable {
  /** When an answer is given up; nothing that a test judges depends on it. */
  private static final Duration LIMIT = Duration.ofMinutes(5);

  /** When what is waited for surely does not come any more. */
  private static final Duration HANGS_AFTER = Duration.ofMinutes(15);

  private static final JsonMapper JSON = JsonMapper.builder().build();

  private static final int UNAVAILABLE = 503;

  private final HttpClient http = HttpClient.newHttpClient();
  private final URI root;
  private final String token;

  public ApiClient(URI root, String name, String password)
      throws IOException, InterruptedException {
    this.root = root;
    this.token =
        JSON.readTree(
                send(
                    HttpRequest.newBuilder(root.resolve("api/v1/session"))
                        .POST(body(Map.of("name", name, "password", password)))))
            .get("token")
            .asString();
  }

  /** The same server as another user. */
  public ApiClient as(String name, String password) throws IOException, InterruptedException {
    return new ApiClient(root, name, password);
  }

  public URI root() {
    return root;
  }

  /** Of its session. */
  public String token() {
    return token;
  }

  public JsonNode get(String path) throws IOException, InterruptedException {
    return JSON.readTree(send(request(path)));
  }

  public JsonNode post(String path, Object body) throws IOException, InterruptedException {
    return JSON.readTree(send(request(path).POST(body(body))));
  }

  /**
   * What the server answers, whatever it is.
   *
   * @param body an empty object where there is none
   */
  public record Reply(int status, JsonNode body) {
    private static Reply of(HttpResponse<String> response) {
      return new Reply(
          response.statusCode(), JSON.readTree(response.body().isBlank() ? "{}" : response.body()));
    }

    public boolean isAccepted() {
      return status < 300;
    }

    /** Whether it cannot do it now; of a command nobody knows then whether it was stored. */
    public boolean isUnavailable() {
      return status == UNAVAILABLE;
    }
  }

  public Reply replyTo(String path) throws IOException, InterruptedException {
    return Reply.of(answer(request(path)));
  }

  public Reply replyTo(String path, Object body) throws IOException, InterruptedException {
    return Reply.of(answer(request(path).POST(body(body))));
  }

  public Reply put(String path, Object body) throws IOException, InterruptedException {
    return Reply.of(answer(request(path).PUT(body(body))));
  }

  public Reply delete(String path) throws IOException, InterruptedException {
    return Reply.of(answer(request(path).DELETE()));
  }

  /** The answer comes later, or fails with the connection. */
  public CompletableFuture<Reply> deleteLater(String path) {
    return http.sendAsync(
            request(path).DELETE().timeout(LIMIT).build(), HttpResponse.BodyHandlers.ofString())
        .thenApply(Reply::of);
  }

  /** The answer comes later, or fails with the connection. */
  public CompletableFuture<Reply> replyLater(String path, Object body) {
    return http.sendAsync(
            request(path)
                .header("Content-Type", "application/json")
                .POST(body(body))
                .timeout(LIMIT)
                .build(),
            HttpResponse.BodyHandlers.ofString())
        .thenApply(Reply::of);
  }

  /** Sends a table of tasks; the answer comes later, or fails with the connection. */
  public CompletableFuture<Reply> replyToTable(String path, String table, String key) {
    return http.sendAsync(tableRequest(path, table, key), HttpResponse.BodyHandlers.ofString())
        .thenApply(Reply::of);
  }

  /** Sends a table of tasks; the answer comes later, or fails with the connection. */
  public CompletableFuture<String> sendTable(String path, String table, String key) {
    return http.sendAsync(tableRequest(path, table, key), HttpResponse.BodyHandlers.ofString())
        .thenApply(ApiClient::good);
  }

  private HttpRequest tableRequest(String path, String table, String key) {
    return request(path)
        .header("Content-Type", "text/csv")
        .header("Idempotency-Key", key)
        .POST(HttpRequest.BodyPublishers.ofString(table))
        .timeout(LIMIT)
        .build();
  }

  /** How many there are of what is listed there. */
  public long count(String path) throws IOException, InterruptedException {
    return answer(request(path)).headers().firstValueAsLong("X-Total-Count").orElseThrow();
  }

  /** Empty where the server says that it cannot tell now. */
  public Optional<JsonNode> tryToGet(String path) throws IOException, InterruptedException {
    return unlessUnavailable(answer(request(path)));
  }

  /** Empty where the server says that it cannot do it now. */
  public Optional<JsonNode> tryToPost(String path, Object body)
      throws IOException, InterruptedException {
    return unlessUnavailable(answer(request(path).POST(body(body))));
  }

  private static Optional<JsonNode> unlessUnavailable(HttpResponse<String> response) {
    return response.statusCode() == UNAVAILABLE
        ? Optional.empty()
        : Optional.of(JSON.readTree(good(response)));
  }

  /** Reads the live events until one satisfies the condition. */
  public void awaitSnapshot(Predicate<JsonNode> condition)
      throws IOException, InterruptedException {
    long end = System.nanoTime() + HANGS_AFTER.toNanos();
    AtomicReference<JsonNode> last = new AtomicReference<>();
    HttpRequest events = request("events").build();
    try (Stream<String> lines = http.send(events, HttpResponse.BodyHandlers.ofLines()).body()) {
      boolean isSatisfied =
          lines
              .takeWhile(_ -> System.nanoTime() < end) // one comes at least every 5 s
              .filter(line -> line.startsWith("data: "))
              .map(line -> JSON.readTree(line.substring("data: ".length())))
              .filter(data -> data.has("robots")) // else it says only that it is alive
              .peek(last::set)
              .anyMatch(condition);
      if (!isSatisfied) {
        throw new AssertionError("no live event satisfied it; the last one: " + last.get());
      }
    }
  }

  private HttpRequest.Builder request(String path) {
    return HttpRequest.newBuilder(root.resolve("api/v1/" + path))
        .header("Authorization", "Bearer " + token);
  }

  private static HttpRequest.BodyPublisher body(Object body) {
    return HttpRequest.BodyPublishers.ofString(JSON.writeValueAsString(body));
  }

  private String send(HttpRequest.Builder request) throws IOException, InterruptedException {
    return good(answer(request));
  }

  private HttpResponse<String> answer(HttpRequest.Builder request)
      throws IOException, InterruptedException {
    return http.send(
        request.header("Content-Type", "application/json").timeout(LIMIT).build(),
        HttpResponse.BodyHandlers.ofString());
  }

  private static String good(HttpResponse<String> response) {
    if (response.statusCode() >= 300) {
      throw new AssertionError(response.statusCode() + ": " + response.body());
    }
    return response.body();
  }

  @Override
  public void close() {
    http.close();
  }
}
