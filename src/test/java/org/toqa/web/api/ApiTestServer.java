package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.json.JsonMapper;

/** A server over a fleet with one robot, and a client with a manager's token. */
abstract class ApiTestServer {
  static final JsonMapper JSON = new JsonMapper();
  static final String GOOD_TASK =
      """
      {"name": " Box of bolts ", "load": 2.5, "start": {"station": "Dock A"},
       "goal": {"x": 10.35, "y": 1.05}}
      """;

  WebTestServer server;
  TestClient visitor;
  String token;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.start();
    visitor = new TestClient(server.root());
    token = tokenOf(WebTestServer.MANAGER);
    server
        .fleet()
        .setRobots(Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275));
  }

  @AfterEach
  void stop() throws Exception {
    visitor.close();
    server.close();
  }

  long add(String bearer) {
    return JSON.readTree(post(bearer, "api/v1/tasks", GOOD_TASK).body()).get("id").longValue();
  }

  HttpResponse<String> send(String method, String path, String body) {
    return visitor.send(
        visitor
            .request(path)
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .method(method, BodyPublishers.ofString(body))
            .build());
  }

  String tokenOf(String name) {
    HttpResponse<String> answer =
        post(
            null,
            "api/v1/session",
            "{\"name\":\"%s\",\"password\":\"%s\"}".formatted(name, WebTestServer.PASSWORD));
    assertEquals(200, answer.statusCode());
    return JSON.readTree(answer.body()).get("token").stringValue();
  }

  String state(String robot) {
    return JSON.readTree(get("api/v1/robots/" + robot).body()).get("state").stringValue();
  }

  HttpResponse<String> get(String path) {
    return visitor.send(visitor.request(path).header("Authorization", "Bearer " + token).build());
  }

  HttpResponse<String> post(@Nullable String bearer, String path, String body) {
    var request = visitor.request(path).header("Content-Type", "application/json; charset=utf-8");
    if (bearer != null) {
      request.header("Authorization", "Bearer " + bearer);
    }
    return visitor.send(request.POST(BodyPublishers.ofString(body)).build());
  }

  static String detail(HttpResponse<String> answer) {
    return JSON.readTree(answer.body()).get("detail").stringValue();
  }
}
