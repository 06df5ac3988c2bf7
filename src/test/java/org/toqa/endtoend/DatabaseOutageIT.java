package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.Needed;
import org.toqa.testbed.OwnMySql;
import tools.jackson.databind.JsonNode;

/**
 * MySQL goes away while robots carry, and comes back. Its connections are cut in {@link
 * CrashMatrixIT}.
 */
@Tag("full")
class DatabaseOutageIT {
  private static final long LIMIT_NANOS = TimeUnit.MINUTES.toNanos(10);

  @TempDir private Path folder;

  @FunctionalInterface
  private interface Happening {
    void happens() throws Exception;
  }

  @Test
  void robotsStandEverybodyIsToldAndThenAllGoesOn() throws Exception {
    // where somebody brings his own database server there may be none that a test may kill
    Needed.orLeftOut(
        System.getenv("TOQA_TEST_MYSQL_URL") == null,
        "a MySQL that a test may kill: run ./toqa test without TOQA_TEST_MYSQL_URL");
    try (OwnMySql mySql = new OwnMySql(folder)) {
      Path config = folder.resolve("server.yaml");
      Files.writeString(config, "database:\n  url: \"%s\"\n".formatted(mySql.url()));
      try (RunningServer server =
          new RunningServer(
              folder, "--config", config.toString(), "--simulate", "1", "--speed", "10")) {
        goesAwayAndComesBack(server, "frozen", mySql::freeze, mySql::thaw);
        goesAwayAndComesBack(server, "killed", mySql::kill, mySql::startAgain);
        assertEquals(2, server.api().get("tasks").size());
        server.await("history?kind=fleet.database-back", h -> h.get("events").size() == 2);
        assertEquals(2, server.api().get("history?kind=fleet.database-away").get("events").size());
      }
    }
  }

  private static void goesAwayAndComesBack(
      RunningServer server, String name, Happening away, Happening back) throws Exception {
    long task = server.addTask(name, "Goods-in 1", "Packing 1");
    server.awaitState(task, "TO_OBJECT");

    away.happens();
    awaitHealth(server.root(), 503);
    Optional<JsonNode> refused =
        server.api().tryToPost("tasks", RunningServer.order("refused", "Mill", "Assembly"));
    assertEquals(Optional.empty(), refused);
    awaitStandingRobots(server);
    back.happens();

    awaitHealth(server.root(), 200);
    server.awaitState(task, "DONE");
    server.await("tasks/" + task, t -> t.toString().contains("\"Done\""));
    assertEquals(1, server.eventCount(task, "Created by"));
    assertEquals(1, server.eventCount(task, "Picked up"));
    assertEquals(1, server.eventCount(task, "Delivered"));
  }

  private static void awaitHealth(URI root, int status) throws Exception {
    try (HttpClient http = HttpClient.newHttpClient()) {
      HttpRequest health = HttpRequest.newBuilder(root.resolve("api/v1/health")).build();
      long end = System.nanoTime() + LIMIT_NANOS;
      while (true) {
        HttpResponse<String> answer = http.send(health, HttpResponse.BodyHandlers.ofString());
        if (answer.statusCode() == status) {
          assertTrue(status == 200 || answer.body().contains("The database does not answer."));
          return;
        }
        assertTrue(System.nanoTime() < end, answer::body);
        TimeUnit.MILLISECONDS.sleep(50);
      }
    }
  }

  /** They have come to where they may not go on from, and are heard. */
  private static void awaitStandingRobots(RunningServer server) throws Exception {
    long end = System.nanoTime() + LIMIT_NANOS;
    JsonNode before = server.api().get("robots");
    while (true) {
      TimeUnit.SECONDS.sleep(2); // 20 s of the robots' time
      JsonNode now = server.api().get("robots");
      for (JsonNode robot : now) {
        assertTrue(!robot.get("state").asString().equals("LOST"), robot::toString);
      }
      if (now.findValues("pose").equals(before.findValues("pose"))) {
        return;
      }
      assertTrue(System.nanoTime() < end, "the robots still drive: " + now);
      before = now;
    }
  }
}
