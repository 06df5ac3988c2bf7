package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.CheckRefusedException.Reason;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The path between two places, in the API. */
class ApiPathTest {
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
  void placesAreStationsOrPoints() {
    JsonNode path = path("start=Dock%20A&goal=8.2,2.2", 200);

    assertEquals(8.2, path.get("points").get(path.get("points").size() - 1).get("x").asDouble());
    assertTrue(path.get("metres").asDouble() > 0);
    JsonNode back = path("start=8.2,2.2&goal=Dock%20A", 200);
    assertEquals(path.get("metres").asDouble(), back.get("metres").asDouble(), 1e-9);
  }

  @Test
  void whatIsMissingOrNoPlaceIsToldByItsName() {
    JsonNode missing = path("start=%20", 422);
    assertEquals("start", missing.get("errors").get(0).get("field").asString());
    assertEquals("goal", missing.get("errors").get(1).get("field").asString());
    assertTrue(missing.get("detail").asString().contains("such as 3.45,9.15"));

    JsonNode unknown = path("start=Dock%20A&goal=1e9,2", 422);
    assertEquals("goal", unknown.get("errors").get(0).get("field").asString());
    path("start=Dock%20A&goal=8.2,2.2&floor=nowhere", 404);
  }

  @Test
  void whoHasTooMuchCheckedAtOnceIsToldToWait() {
    server.fleet().refuseChecks(Reason.TOO_MANY);

    path("start=Dock%20A&goal=8.2,2.2", 429);
  }

  private JsonNode path(String query, int status) {
    HttpResponse<String> answer = clerk.get("api/v1/path?" + query);
    assertEquals(status, answer.statusCode(), answer.body());
    return JsonMapper.shared().readTree(answer.body());
  }
}
