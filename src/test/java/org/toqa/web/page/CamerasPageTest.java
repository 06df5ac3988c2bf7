package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.testbed.Hall;
import org.toqa.web.WebServerTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Cameras on their page, on the control page, beside the map, and by the API. */
class CamerasPageTest extends WebServerTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final byte[] PICTURE = {(byte) 0xFF, (byte) 0xD8, (byte) 0xFF, 1, 2, 3};

  private HttpServer device;

  @BeforeEach
  void start() throws IOException {
    server.forgetWork();
    server
        .fleet()
        .setRobots(Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275));
    device = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    device.createContext(
        "/",
        exchange -> {
          try (exchange) {
            exchange.getResponseHeaders().set("Content-Type", "image/jpeg");
            exchange.sendResponseHeaders(200, PICTURE.length);
            exchange.getResponseBody().write(PICTURE);
          }
        });
    device.start();
  }

  @AfterEach
  void stop() {
    device.stop(0);
  }

  private String url() {
    return "http://max:secret@127.0.0.1:" + device.getAddress().getPort() + "/still.jpg";
  }

  private long add(Map<String, String> order) {
    HttpResponse<String> answer =
        manager.postJson("api/v1/cameras", JSON.writeValueAsString(order));
    assertEquals(201, answer.statusCode(), answer::body);
    return JSON.readTree(answer.body()).get("id").asLong();
  }

  @Test
  void pictureComesThroughTheServerAndItsAddressIsForManagers() {
    long id = add(Map.of("name", "front", "url", url(), "robot", "r1"));

    HttpResponse<byte[]> picture =
        clerk.send(
            clerk.request("api/v1/cameras/" + id + "/picture").build(), BodyHandlers.ofByteArray());
    assertEquals(200, picture.statusCode());
    assertArrayEquals(PICTURE, picture.body());
    assertEquals("image/jpeg", picture.headers().firstValue("Content-Type").orElse(""));
    assertEquals("no-store", picture.headers().firstValue("Cache-Control").orElse(""));
    JsonNode listed = JSON.readTree(clerk.get("api/v1/cameras").body()).get(0);
    assertTrue(listed.get("url").isNull());
    assertFalse(clerk.get("cameras").body().contains("127.0.0.1"));
    assertFalse(manager.get("cameras").body().contains("secret"));
    assertEquals(
        url(), JSON.readTree(manager.get("api/v1/cameras").body()).get(0).get("url").asString());
    assertEquals(401, anonymous.get("api/v1/cameras/" + id + "/picture").statusCode());
  }

  @Test
  void cameraThatIsAwayHasASentence() {
    long id = add(Map.of("name", "front", "url", url(), "robot", "r1"));
    device.stop(0);

    HttpResponse<String> answer = clerk.get("api/v1/cameras/" + id + "/picture");
    assertEquals(502, answer.statusCode());
    assertTrue(answer.body().contains("The camera does not answer"), answer.body());
  }

  @Test
  void cameraIsShownWhereItBelongsAndIsRemoved() {
    add(Map.of("name", "front", "url", url(), "robot", "r1"));
    HttpResponse<String> added =
        manager.post("cameras", Map.of("name", "door", "url", url(), "robot", "", "floor", "hall"));
    assertEquals(303, added.statusCode(), added::body);

    String control = clerk.get("robots/r1/control").body();
    assertTrue(control.contains("front") && !control.contains("<bdi>door</bdi>"));
    String map = clerk.get("map").body();
    assertTrue(map.contains("<bdi>door</bdi>") && !map.contains("<bdi>front</bdi>"));
    assertFalse(clerk.get("cameras").body().contains("Add a camera"), "it is for managers");
    for (JsonNode camera : JSON.readTree(clerk.get("api/v1/cameras").body())) {
      String path = "cameras/" + camera.get("id").asLong() + "/delete";
      assertEquals(403, clerk.post(path, Map.of()).statusCode());
      assertEquals(303, manager.post(path, Map.of()).statusCode());
      assertEquals(404, manager.post(path, Map.of()).statusCode());
    }
    assertEquals(
        "[\"camera.removed\",\"camera.removed\",\"camera.added\",\"camera.added\"]",
        JSON.writeValueAsString(
            JSON.readTree(manager.get("api/v1/history?kind=camera").body())
                .get("events")
                .findValuesAsString("kind")));
  }

  @Test
  void cameraIsChangedByPageAndApi() {
    long front = add(Map.of("name", "front", "url", "http://127.0.0.1:9/", "robot", "r1"));
    long door = add(Map.of("name", "door", "url", url(), "floor", "hall"));
    String form = manager.get("cameras?edit=" + front).body();
    assertTrue(form.contains("/cameras/" + front + "/change") && form.contains("127.0.0.1:9/"));
    assertFalse(clerk.get("cameras?edit=" + front).body().contains("127.0.0.1"));

    String path = "cameras/" + front + "/change";
    Map<String, String> order = Map.of("name", "gate", "url", url(), "robot", "", "floor", "hall");
    assertEquals(403, clerk.post(path, order).statusCode());
    assertEquals(303, manager.post(path, order).statusCode());
    assertTrue(clerk.get("map").body().contains("<bdi>gate</bdi>"));
    assertEquals(200, clerk.get("api/v1/cameras/" + front + "/picture").statusCode());
    HttpResponse<String> taken = manager.post("cameras/" + door + "/change", order);
    assertEquals(422, taken.statusCode());
    assertTrue(taken.body().contains("There is a camera gate already"), taken::body);

    String same = JSON.writeValueAsString(Map.of("name", "gate", "url", url(), "robot", "r1"));
    HttpResponse<String> answer = manager.sendJson("PUT", "api/v1/cameras/" + front, same);
    assertEquals(200, answer.statusCode(), "its own name may stay");
    assertEquals("r1", JSON.readTree(answer.body()).get("robot").asString());
    assertTrue(clerk.get("robots/r1/control").body().contains("<bdi>gate</bdi>"));
    assertEquals(404, manager.sendJson("PUT", "api/v1/cameras/999", same).statusCode());
    String history = manager.get("api/v1/history?kind=camera.changed").body();
    assertTrue(history.contains("changed the camera front, which is called gate now"), history);
    assertTrue(history.contains("changed the camera gate\""), history);
  }

  @ParameterizedTest
  @CsvSource({
    "front, http://127.0.0.1:9/, r1, '', name",
    "other, ftp://127.0.0.1/, r1, '', url",
    "other, file:///etc/passwd, r1, '', url",
    "other, http://, r1, '', url",
    "other, http://127.0.0.1:9/, r9, '', robot",
    "other, http://127.0.0.1:9/, '', nowhere, floor",
    "other, http://127.0.0.1:9/, '', '', robot"
  })
  void whatIsWrongIsRefusedWithASentence(
      String name, String url, String robot, String floor, String field) {
    add(Map.of("name", "front", "url", url(), "robot", "r1"));

    HttpResponse<String> answer =
        manager.postJson(
            "api/v1/cameras",
            JSON.writeValueAsString(
                Map.of("name", name, "url", url, "robot", robot, "floor", floor)));
    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains("\"" + field + "\""), answer.body());
    assertEquals(1, JSON.readTree(clerk.get("api/v1/cameras").body()).size());
  }
}
