package org.toqa.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.RealMySql;
import org.toqa.testbed.StockTomcat;
import tools.jackson.databind.JsonNode;

/** The same WAR on a Tomcat as its makers ship it. */
@Tag("full")
class StockTomcatIT {
  private static final Path WAR = Path.of("target/toqa.war");
  private static final String NAME = "boss";
  private static final String PASSWORD = "boss-of-robots";
  private static final Duration LIMIT = Duration.ofMinutes(2);

  @TempDir private Path folder;

  @Test
  void servesTheLoginAndEndsCleanly() throws Exception {
    try (StockTomcat tomcat = StockTomcat.start(folder, WAR, Map.of())) {
      tomcat.awaitStart();
      HttpResponse<String> page = get(tomcat.uri());
      assertEquals(200, page.statusCode(), tomcat.log());
      assertTrue(page.body().contains("name=\"password\""), page.body());
      assertEquals(403, get(tomcat.uri().resolve("org/toqa/launch/Launcher.class")).statusCode());

      tomcat.stop();

      assertFalse(tomcat.log().contains("SEVERE"), tomcat.log());
    }
  }

  @Test
  void takesTheCallersAddressFromTheProxy() throws Exception {
    Map<String, String> variables =
        Map.of("TOQA_PROXY", "127.0.0.1", "TOQA_MANAGER", NAME + ":" + PASSWORD);
    try (StockTomcat tomcat = StockTomcat.start(folder, WAR, variables);
        TestClient behindProxy = new TestClient(tomcat.awaitedUri(), "203.0.113.9")) {
      HttpResponse<String> login =
          behindProxy.send(
              behindProxy
                  .request("api/v1/session")
                  .header("Content-Type", "application/json")
                  .POST(
                      HttpRequest.BodyPublishers.ofString(
                          "{\"name\":\"%s\",\"password\":\"%s\"}".formatted(NAME, PASSWORD)))
                  .build());
      assertEquals(200, login.statusCode(), login.body());
      String token = login.body().replaceFirst("(?s).*\"token\":\"([^\"]+)\".*", "$1");
      String sessions =
          behindProxy
              .send(
                  behindProxy
                      .request("api/v1/users/1/sessions")
                      .header("Authorization", "Bearer " + token)
                      .build())
              .body();
      assertTrue(sessions.contains("203.0.113.9"), sessions);
      String cookie =
          behindProxy
              .send(behindProxy.request("").header("X-Forwarded-Proto", "https").build())
              .headers()
              .firstValue("Set-Cookie")
              .orElseThrow();
      assertTrue(cookie.contains("Secure"), cookie);
    }
  }

  @Test
  void carriesATaskToItsEndOverMySql() throws Exception {
    String database = RealMySql.newDatabase();
    Map<String, String> variables =
        Map.of(
            "TOQA_DATABASE_URL",
            database,
            "TOQA_MANAGER",
            NAME + ":" + PASSWORD,
            "TOQA_SIMULATE",
            "2",
            "TOQA_SPEED",
            "10");
    try (StockTomcat tomcat = StockTomcat.start(folder, WAR, variables)) {
      tomcat.awaitStart();
      JsonNode task;
      try (ApiClient api = new ApiClient(tomcat.uri(), NAME, PASSWORD)) {
        long id =
            api.post(
                    "tasks",
                    Map.of(
                        "name",
                        "crate",
                        "load",
                        2,
                        "start",
                        Map.of("station", "Packing 1"),
                        "goal",
                        Map.of("station", "Packing 2")))
                .get("id")
                .asLong();
        task = awaitEnd(api, "tasks/" + id, tomcat);
      }
      assertEquals("DONE", task.get("state").asString(), task::toString);
      String history = task.get("history").toString();
      assertEquals(2, history.split("Picked up").length, history);
      assertEquals(2, history.split("Delivered").length, history);

      tomcat.stop();

      assertFalse(tomcat.log().contains("SEVERE"), tomcat.log());
    }
    assertEquals("crate DONE", storedTasks(database));
  }

  private static JsonNode awaitEnd(ApiClient api, String path, StockTomcat tomcat)
      throws Exception {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (true) {
      JsonNode task = api.get(path);
      if (Set.of("DONE", "FAILED", "CANCELLED").contains(task.get("state").asString())) {
        return task;
      }
      if (System.nanoTime() > end) {
        throw new AssertionError(task + " has not ended: " + tomcat.log());
      }
      TimeUnit.MILLISECONDS.sleep(100);
    }
  }

  private static String storedTasks(String database) throws SQLException {
    List<String> tasks = new ArrayList<>();
    try (Connection connection = DriverManager.getConnection(database);
        Statement statement = connection.createStatement();
        ResultSet rows = statement.executeQuery("select name, state from tasks")) {
      while (rows.next()) {
        tasks.add(rows.getString(1) + " " + rows.getString(2));
      }
    }
    return String.join(", ", tasks);
  }

  private static HttpResponse<String> get(URI uri) throws Exception {
    try (HttpClient client =
        HttpClient.newBuilder().followRedirects(HttpClient.Redirect.NORMAL).build()) {
      return client.send(HttpRequest.newBuilder(uri).build(), HttpResponse.BodyHandlers.ofString());
    }
  }
}
