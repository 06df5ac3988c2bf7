package org.toqa.app.bench;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Many users of the API at once, each of whom waits for an answer before the next question. */
final class TaskApiClients implements AutoCloseable {
  private static final Duration TIMEOUT = Duration.ofSeconds(60);
  private static final int PAGE_SIZE = 500;
  private static final double LOAD_KG = 2;

  private final HttpClient http = HttpClient.newHttpClient();
  private final URI root;
  private final int clientCount;
  private final String token;
  private int submitted;

  private TaskApiClients(URI root, String token, int count) {
    this.root = root;
    this.token = token;
    this.clientCount = count;
  }

  /**
   * @param root where the pages are, with a slash at its end
   * @param count how many ask at once
   * @throws IOException the server does not answer, or refuses the user
   */
  static TaskApiClients logIn(URI root, BenchUser user, int count)
      throws IOException, InterruptedException {
    return new TaskApiClients(root, requestToken(root, user), count);
  }

  /**
   * A bearer token for that user.
   *
   * @param root where the pages are, with a slash at its end
   * @throws IOException the server does not answer, or refuses the user
   */
  static String requestToken(URI root, BenchUser user) throws IOException, InterruptedException {
    HttpRequest.Builder session = HttpRequest.newBuilder(root.resolve("api/v1/session"));
    try (HttpClient client = HttpClient.newHttpClient()) {
      return json(send(
              client, post(session, Map.of("name", user.name(), "password", user.password())), 200))
          .get("token")
          .asString();
    }
  }

  /**
   * Submits tasks, each with a name of its own.
   *
   * @param tasks how many
   * @return how long each took, milliseconds, in the order of their names
   * @throws Exception a request failed or was refused; the first one that did
   */
  double[] submit(int tasks) throws Exception {
    int first = submitted;
    submitted += tasks;
    List<String> stations = stations();
    double[] millis = new double[tasks];
    AtomicInteger next = new AtomicInteger();
    try (ExecutorService threads = Executors.newVirtualThreadPerTaskExecutor()) {
      List<Future<?>> clients = new ArrayList<>();
      for (int i = 0; i < clientCount; i++) {
        clients.add(
            threads.submit(
                () -> {
                  for (int n = next.getAndIncrement(); n < tasks; n = next.getAndIncrement()) {
                    millis[n] = submit(first + n, stations);
                  }
                  return null;
                }));
      }
      for (Future<?> client : clients) {
        client.get();
      }
    }
    return millis;
  }

  private double submit(int number, List<String> stations)
      throws IOException, InterruptedException {
    Map<String, Object> order =
        Map.of(
            "name",
            String.valueOf(number),
            "load",
            LOAD_KG,
            "start",
            Map.of("station", stations.get(number % stations.size())),
            "goal",
            Map.of("station", stations.get((number + 1) % stations.size())));
    long begun = System.nanoTime();
    send(post(request("tasks"), order), 201);
    return (System.nanoTime() - begun) / 1e6;
  }

  private List<String> stations() throws IOException, InterruptedException {
    List<String> names = new ArrayList<>();
    json(send(request("map"), 200))
        .get("stations")
        .forEach(s -> names.add(s.get("name").asString()));
    return names;
  }

  /**
   * The name of each task that the server has.
   *
   * @throws IOException the server does not answer, or refuses the request
   */
  List<String> taskNames() throws IOException, InterruptedException {
    List<String> names = new ArrayList<>();
    int size;
    do {
      size = names.size();
      json(send(request("tasks?limit=" + PAGE_SIZE + "&offset=" + size), 200))
          .forEach(task -> names.add(task.get("name").asString()));
    } while (names.size() == size + PAGE_SIZE);
    return names;
  }

  private HttpRequest.Builder request(String path) {
    return HttpRequest.newBuilder(root.resolve("api/v1/" + path))
        .header("Authorization", "Bearer " + token);
  }

  private static HttpRequest.Builder post(HttpRequest.Builder request, Map<String, Object> body) {
    return request
        .header("Content-Type", "application/json")
        .POST(BodyPublishers.ofByteArray(JsonMapper.shared().writeValueAsBytes(body)));
  }

  private String send(HttpRequest.Builder request, int expectedStatus)
      throws IOException, InterruptedException {
    return send(http, request, expectedStatus);
  }

  private static String send(HttpClient client, HttpRequest.Builder request, int expectedStatus)
      throws IOException, InterruptedException {
    HttpResponse<String> answer =
        client.send(request.timeout(TIMEOUT).build(), BodyHandlers.ofString());
    if (answer.statusCode() != expectedStatus) {
      throw new IOException("The server answered " + answer.statusCode() + ": " + answer.body());
    }
    return answer.body();
  }

  private static JsonNode json(String text) {
    return JsonMapper.shared().readTree(text);
  }

  @Override
  public void close() {
    http.close();
  }
}
