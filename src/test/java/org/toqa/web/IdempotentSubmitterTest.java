package org.toqa.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.json.JsonMapper;

/** The same order twice is one task. */
class IdempotentSubmitterTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final Pattern KEY_FIELD =
      Pattern.compile("name=\"idempotencyKey\" value=\"([^\"]+)\"");
  private WebTestServer server;
  private TestClient clerk;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.start();
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
  }

  @AfterEach
  void stop() throws Exception {
    clerk.close();
    server.close();
  }

  @Test
  void anOrderThatComesAgainWithItsKeyGetsItsTask() {
    long first = id(post(clerk, "a", "crate"));

    assertEquals(first, id(post(clerk, "a", "crate")));
    assertNotEquals(first, id(post(clerk, "b", "crate")));
    HttpResponse<String> other = post(clerk, "a", "another crate");
    assertEquals(422, other.statusCode());
    assertTrue(other.body().contains("another order"), other.body());
    try (TestClient manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      assertNotEquals(first, id(post(manager, "a", "crate")), "a key is its user's own");
    }
    assertEquals(400, post(clerk, "a key", "crate").statusCode(), "blank");
    assertEquals(400, post(clerk, "x".repeat(129), "crate").statusCode());
    assertEquals(3, server.fleet().count());
  }

  @Test
  void ordersWithOneKeyThatComeAtOnceAreOneTask() throws Exception {
    String csrf = clerk.csrf();
    try (ExecutorService clients = Executors.newFixedThreadPool(16)) {
      List<Future<HttpResponse<String>>> answers = new ArrayList<>();
      for (int i = 0; i < 32; i++) {
        answers.add(clients.submit(() -> post(clerk, csrf, "at-once", "crate")));
      }
      Set<Long> ids = new HashSet<>();
      for (Future<HttpResponse<String>> answer : answers) {
        ids.add(id(answer.get()));
      }
      assertEquals(1, ids.size());
    }
    assertEquals(1, server.fleet().count());
  }

  @Test
  void aFormThatIsSentTwiceIsOneTask() {
    Matcher field = KEY_FIELD.matcher(clerk.get("tasks/new").body());
    assertTrue(field.find());
    Map<String, String> form =
        new HashMap<>(
            Map.of(
                "name",
                "x",
                "load",
                "1",
                "startStation",
                "Dock A",
                "goalStation",
                "Shelf 3",
                "idempotencyKey",
                field.group(1)));

    String first = location(clerk.post("tasks/new", form));

    assertEquals(first, location(clerk.post("tasks/new", form)));
    form.put("name", "y");
    assertNotEquals(first, location(clerk.post("tasks/new", form)), "another order");
    form.remove("idempotencyKey");
    assertNotEquals(
        location(clerk.post("tasks/new", form)), location(clerk.post("tasks/new", form)));
  }

  private static String location(HttpResponse<String> answer) {
    assertEquals(303, answer.statusCode(), answer.body());
    return answer.headers().firstValue("Location").orElseThrow();
  }

  private static long id(HttpResponse<String> answer) {
    assertEquals(201, answer.statusCode(), answer.body());
    return JSON.readTree(answer.body()).get("id").asLong();
  }

  private static HttpResponse<String> post(TestClient visitor, String key, String name) {
    return post(visitor, visitor.csrf(), key, name);
  }

  private static HttpResponse<String> post(
      TestClient visitor, String csrf, String key, String name) {
    return visitor.send(
        visitor
            .request("api/v1/tasks")
            .header("Content-Type", "application/json")
            .header("X-CSRF-Token", csrf)
            .header("Idempotency-Key", key)
            .POST(HttpRequest.BodyPublishers.ofString(order(name)))
            .build());
  }

  private static String order(String name) {
    return """
        {"name":"%s","load":1.5,"start":{"station":"Dock A"},"goal":{"x":9,"y":1.05},
         "deadline":"2030-01-01T10:00:00.1234567Z"}
        """
        .formatted(name);
  }
}
