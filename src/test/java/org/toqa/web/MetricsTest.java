package org.toqa.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Role;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;

/** What Prometheus reads. */
class MetricsTest {
  private WebTestServer server;
  private TestClient clerk;
  private TestClient administrator;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.start();
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
    server.addUser("Ada", null, Role.ADMINISTRATOR);
    administrator = TestClient.signedIn(server.root(), "Ada");
    server
        .fleet()
        .changeRobots(
            none ->
                List.of(
                    Hall.robot("r1", RobotState.IDLE, new Pose(1, 1, 0), "127.0.0.1", 7275),
                    Hall.robot("r2", RobotState.IDLE, new Pose(2, 1, 0), "127.0.0.1", 7276),
                    Hall.robot("r3", RobotState.LOST, new Pose(3, 1, 0), "127.0.0.1", 7277)));
  }

  @AfterEach
  void stop() throws Exception {
    administrator.close();
    clerk.close();
    server.close();
  }

  @Test
  void theFleetIsCounted() {
    for (int i = 0; i < 3; i++) {
      clerk.post(
          "tasks/new",
          Map.of("name", "x", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3"));
    }
    server.fleet().changeTask(2, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");

    Map<String, Double> metrics = metrics();

    assertEquals(2, metrics.get("toqa_robots{state=\"idle\"}"));
    assertEquals(1, metrics.get("toqa_robots{state=\"lost\"}"));
    assertEquals(0, metrics.get("toqa_robots{state=\"driving\"}"));
    assertEquals(1, metrics.get("toqa_tasks{state=\"carrying\"}"));
    assertEquals(0, metrics.get("toqa_fleet_paused"));
    clerk.post("fleet/pause", Map.of());
    assertEquals(1, metrics().get("toqa_fleet_paused"));
  }

  @Test
  void whatIsLeftOutOfWhatRobotsSayIsCounted() {
    try (Metrics metrics = new Metrics(server.fleet().snapshots())) {
      metrics.bindPassedOver(kind -> kind == RobotMessageKind.STATE ? 7 : 0);

      String text = metrics.scrape(false);
      assertTrue(text.contains("toqa_robot_messages_left_out_total{kind=\"state\"} 7.0"), text);
      assertTrue(text.contains("toqa_robot_messages_left_out_total{kind=\"obstacle\"} 0.0"), text);
    }
  }

  @Test
  void whatTellsOfOtherSitesAndStrangersIsForAdministrators() {
    try (Metrics metrics = new Metrics(server.fleet().snapshots(), true)) {
      metrics.recordRequest("POST", "/login", 200, Duration.ofMillis(3));

      String ofSite = metrics.scrape(false);
      assertTrue(ofSite.contains("toqa_robots{"), ofSite);
      for (String secret : List.of("toqa_http_", "jvm_", "process_", "system_")) {
        assertFalse(ofSite.contains(secret), ofSite);
        assertTrue(metrics.scrape(true).contains(secret), secret);
      }
    }
  }

  @Test
  void requestsAreCountedByRouteAndNotByPath() {
    for (int i = 1; i <= 3; i++) {
      assertEquals(404, clerk.get("tasks/" + i).statusCode());
      clerk.get("nothing-" + i);
    }

    Map<String, Double> metrics = metrics();

    assertEquals(
        3,
        metrics.get(
            "toqa_http_requests_seconds_count{door=\"/tasks/{id}\",method=\"GET\",status=\"4xx\"}"));
    assertEquals(
        3,
        metrics.get(
            "toqa_http_requests_seconds_count{door=\"none\",method=\"none\",status=\"4xx\"}"));
  }

  @Test
  void theProcessIsMeasured() {
    Map<String, Double> metrics = metrics();

    assertTrue(metrics.keySet().stream().anyMatch(name -> name.startsWith("jvm_memory_used")));
    assertTrue(metrics.containsKey("process_uptime_seconds"));
    assertEquals(0, metrics.get("toqa_streams"));
    assertFalse(metrics(clerk).keySet().stream().anyMatch(name -> name.startsWith("jvm_")));
    assertEquals(0, metrics(clerk).get("toqa_streams"));
  }

  private Map<String, Double> metrics() {
    return metrics(administrator);
  }

  private static Map<String, Double> metrics(TestClient reader) {
    HttpResponse<String> answer = reader.get("api/v1/metrics");
    assertEquals(200, answer.statusCode());
    Map<String, Double> metrics = new TreeMap<>();
    for (String line : answer.body().lines().filter(l -> !l.startsWith("#")).toList()) {
      int blank = line.lastIndexOf(' ');
      metrics.put(line.substring(0, blank), Double.valueOf(line.substring(blank + 1)));
    }
    return metrics;
  }
}
