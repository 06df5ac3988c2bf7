package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.WorkHistory;
import org.toqa.web.access.Permission;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Holds the API's description against the routes and against what really comes. */
class OpenApiTest {
  private static final JsonMapper JSON = new JsonMapper();

  private static WebTestServer server;
  private static TestClient clerk;
  private static JsonNode document;

  @BeforeAll
  static void start() throws Exception {
    server = WebTestServer.start();
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
    document = JSON.readTree(clerk.get("api/v1/openapi.json").body());
    server
        .fleet()
        .changeRobots(
            none ->
                List.of(
                    Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275)));
    WorkHistory.in(server).addHour(Instant.now().minusSeconds(3600));
    clerk.post(
        "tasks/new",
        Map.of("name", "x", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3"));
  }

  @AfterAll
  static void stop() throws Exception {
    clerk.close();
    server.close();
  }

  @Test
  void everyOperationHasOneTag() {
    List<String> headings =
        document.get("tags").valueStream().map(tag -> tag.get("name").asString()).toList();
    for (JsonNode path : document.get("paths")) {
      for (JsonNode operation : path) {
        assertEquals(1, operation.path("tags").size(), operation::toString);
        assertTrue(headings.contains(operation.get("tags").get(0).asString()), operation::toString);
      }
    }
  }

  @Test
  void everyApiRouteIsDescribedAndNoOther() {
    Set<String> described = new TreeSet<>();
    for (Map.Entry<String, JsonNode> path : document.get("paths").properties()) {
      for (String method : path.getValue().propertyNames()) {
        described.add(method.toUpperCase(Locale.ROOT) + " " + path.getKey());
      }
    }

    Set<String> routes =
        Routes.all().stream()
            .filter(Route::isApi)
            .map(route -> route.method() + " " + route.path())
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(routes, described);
  }

  @Test
  void onlyAnonymousRoutesAreDescribedWithoutSecurity() {
    for (Route route : Routes.all().stream().filter(Route::isApi).toList()) {
      JsonNode operation =
          document.get("paths").get(route.path()).get(route.method().toLowerCase(Locale.ROOT));
      boolean forStrangers = route.permission() == Permission.ANONYMOUS;
      assertEquals(forStrangers, operation.has("security"), route.toString());
    }
  }

  @Test
  void everyOperationButHealthDescribesTheRateLimit() {
    for (Map.Entry<String, JsonNode> path : document.get("paths").properties()) {
      for (JsonNode operation : path.getValue()) {
        assertEquals(
            !path.getKey().equals("/api/v1/health"),
            operation.at("/responses/429/$ref").asString("").endsWith("/TooManyRequests"),
            path::getKey);
      }
    }
  }

  @Test
  void everyBodyOfJsonHasAnExample() {
    for (Map.Entry<String, JsonNode> path : document.get("paths").properties()) {
      for (JsonNode operation : path.getValue()) {
        JsonNode body = operation.at("/requestBody/content/application~1json");
        assertTrue(body.isMissingNode() || body.has("example"), path::getKey);
      }
    }
  }

  @Test
  void examplesAreAcceptedAsTheyStand() throws Exception {
    List<String> tried =
        List.of(
            "post /api/v1/tasks 201",
            "post /api/v1/tasks/preview 200",
            "put /api/v1/tasks/{id} 200",
            "post /api/v1/tasks/{id}/priority 200",
            "post /api/v1/orders 201",
            "post /api/v1/schedules 201",
            "post /api/v1/templates 201",
            "put /api/v1/templates/{id} 200",
            "post /api/v1/robots 201",
            "put /api/v1/robots/{name} 200",
            "put /api/v1/robots/{name}/limits/{reading} 200",
            "post /api/v1/robots/{name}/locate 200",
            "post /api/v1/network/devices 201",
            "put /api/v1/network/devices/{id} 200",
            "post /api/v1/cameras 201",
            "put /api/v1/cameras/{id} 200",
            "post /api/v1/users 201",
            "post /api/v1/floors 201",
            "post /api/v1/floors/{floor}/draft/check 200",
            "put /api/v1/floors/{floor}/draft 200",
            "post /api/v1/floors/{floor}/allocator 200",
            "post /api/v1/tasks/{id}/cancel 200");
    try (WebTestServer fresh = WebTestServer.start();
        TestClient manager = TestClient.signedIn(fresh.root(), WebTestServer.MANAGER)) {
      fresh
          .fleet()
          .changeRobots(
              none ->
                  List.of(Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "h", 7275)));
      JsonNode offered = JSON.readTree(manager.get("api/v1/openapi.json").body()).get("paths");
      for (String line : tried) {
        String[] word = line.split(" ", -1);
        String path =
            word[1]
                .substring(1)
                .replace("{id}", "1")
                .replace("{name}", "r1")
                .replace("{reading}", "range")
                .replace("{floor}", "hall");
        String example = example(offered, word[1], word[0]);

        HttpResponse<String> answer =
            manager.sendJson(word[0].toUpperCase(Locale.ROOT), path, example);

        assertEquals(word[2], String.valueOf(answer.statusCode()), () -> line + answer.body());
      }
    }
  }

  private static String example(JsonNode paths, String path, String method) {
    return paths
        .get(path)
        .get(method)
        .at("/requestBody/content/application~1json/example")
        .toString();
  }

  @Test
  void everyReferenceLeadsSomewhere() {
    for (JsonNode reference : document.findValues("$ref")) {
      assertTrue(
          !document.at(reference.stringValue().substring(1)).isMissingNode(),
          reference.stringValue());
    }
  }

  @Test
  void whatComesHasTheFieldsThatAreDescribed() {
    assertDescribed("Map", "api/v1/map", "");
    assertDescribed("Task", "api/v1/tasks/1", "");
    assertDescribed("Place", "api/v1/tasks/1", "/start");
    assertDescribed("Event", "api/v1/tasks/1", "/history/0");
    assertDescribed("Robot", "api/v1/robots/r1", "");
    assertDescribed("Pose", "api/v1/robots/r1", "/pose");
    assertDescribed("Network", "api/v1/network", "");
    assertDescribed("NetworkEntry", "api/v1/network", "/devices/0");
    assertDescribed("FloorSummary", "api/v1/floors", "/0");
    assertDescribed("DrawnFloor", "api/v1/floors/hall", "");
    assertDescribed("Drawing", "api/v1/floors/hall", "/drawing");
    assertDescribed("Draft", "api/v1/floors/hall/draft", "");
    assertDescribed("NamedPlace", "api/v1/map", "/stations/0");
    assertDescribed("FloorTracks", "api/v1/tracks", "");
    assertDescribed("RobotTrack", "api/v1/tracks", "/robots/0");
    assertDescribed("Statistics", "api/v1/statistics", "");
    assertDescribed("Figures", "api/v1/statistics", "/total");
    assertDescribed("Spread", "api/v1/statistics", "/total/delivery");
    assertDescribed("Bucket", "api/v1/statistics", "/series/0");
    assertDescribed("RobotUse", "api/v1/statistics", "/robots/0");
  }

  @Test
  void theStatesAreThoseThatThereAre() {
    assertEquals(words(TaskState.values()), described("Task", "state"));
    assertEquals(words(RobotState.values()), described("Robot", "state"));
  }

  private static void assertDescribed(String schema, String path, String part) {
    JsonNode came = JSON.readTree(clerk.get(path).body()).at(part);
    assertEquals(
        new TreeSet<>(document.at("/components/schemas/" + schema + "/properties").propertyNames()),
        new TreeSet<>(came.propertyNames()),
        schema);
  }

  private static List<String> described(String schema, String field) {
    return document
        .at("/components/schemas/%s/properties/%s/enum".formatted(schema, field))
        .values()
        .stream()
        .map(JsonNode::stringValue)
        .toList();
  }

  private static List<String> words(Enum<?>[] values) {
    return List.of(values).stream().map(Enum::name).toList();
  }
}
