package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;
import tools.jackson.databind.JsonNode;

/** How the API reads requests: methods, bodies, paths, tokens. */
class ApiRequestsTest extends ApiTestServer {
  @Test
  void theServerIsUp() {
    assertEquals("{\"status\":\"UP\"}", visitor.get("api/v1/health").body());
  }

  @Test
  void whatAilsTheFleetIsInItsHealth() {
    server.fleet().setAlert(Phrase.DATABASE_AWAY.with());

    HttpResponse<String> answer = visitor.get("api/v1/health");

    assertEquals(503, answer.statusCode());
    JsonNode health = JSON.readTree(answer.body());
    assertEquals("DEGRADED", health.get("status").stringValue());
    String reason = health.get("alerts").get(0).stringValue();
    assertTrue(reason.startsWith("The database does not answer."), reason);
  }

  @Test
  void healthTellsStrangersNoNames() {
    Sentence floor = Phrase.FLOOR_IS_MISSING.with("Secret hall", 3, 4);
    server.fleet().setFailure(Phrase.PART_FAILS.with(Phrase.DISPATCH_PART.with("Secret hall")));
    server.fleet().setAlert(floor);

    JsonNode health = JSON.readTree(visitor.get("api/v1/health").body());

    assertEquals("DOWN", health.get("status").stringValue());
    assertEquals(2, health.get("alerts").size());
    for (JsonNode alert : health.get("alerts")) {
      assertTrue(alert.stringValue().contains("…"), alert.stringValue());
      assertFalse(alert.stringValue().matches(".*(Secret|[0-9]).*"), alert.stringValue());
    }
  }

  @Test
  void whatPeopleShouldSeeToIsNoFaultOfTheFleet() {
    Sentence advice = Phrase.SUPERVISION_BLIND.with("s1", "hall");
    server.fleet().setAlert(advice);
    server.fleet().setAdvice(advice);

    assertEquals("{\"status\":\"UP\"}", visitor.get("api/v1/health").body());
  }

  @Test
  void aFleetThatCannotGoOnIsDownAndSaysWhy() {
    server.fleet().setFailure(Phrase.FLEET_STANDS.with(61));

    HttpResponse<String> answer = visitor.get("api/v1/health");

    assertEquals(503, answer.statusCode());
    JsonNode health = JSON.readTree(answer.body());
    assertEquals("DOWN", health.get("status").stringValue());
    assertEquals(1, health.get("alerts").size());
    String reason = health.get("alerts").get(0).stringValue();
    assertTrue(reason.startsWith("The fleet has not answered for 61 s."), reason);
  }

  @Test
  void aWrongPasswordGivesNoToken() {
    HttpResponse<String> answer =
        post(null, "api/v1/session", "{\"name\":\"Max\",\"password\":\"wrong\"}");

    assertEquals(401, answer.statusCode());
    assertEquals("Wrong name or password. Check both and try again.", detail(answer));
  }

  @Test
  void aNumberOfAMillionDigitsIsRefused() {
    String digits = "9".repeat(50_000);

    assertEquals(
        400, post(token, "api/v1/tasks", "{\"name\":\"x\",\"load\":" + digits + "}").statusCode());
  }

  @Test
  void aBodyTooLargeIsRefused() {
    String body = "{\"name\":\"" + "x".repeat(64 * 1024) + "\"}";

    HttpResponse<String> answer = post(token, "api/v1/tasks", body);

    assertEquals(413, answer.statusCode());
    assertEquals("The body is larger than 64 KiB. Send less.", detail(answer));
  }

  @ParameterizedTest
  @ValueSource(strings = {"text/plain", "application/xml", "application/x-www-form-urlencoded"})
  void anotherMediaTypeIsRefused(String mediaType) {
    HttpResponse<String> answer =
        visitor.send(
            visitor
                .request("api/v1/tasks")
                .header("Authorization", "Bearer " + token)
                .header("Content-Type", mediaType)
                .POST(BodyPublishers.ofString(GOOD_TASK))
                .build());

    assertEquals(415, answer.statusCode());
    assertEquals("Send the body as application/json.", detail(answer));
  }

  @Test
  void theWrongMethodNamesTheRightOnes() {
    HttpResponse<String> answer = visitor.send("PUT", "api/v1/tasks");

    assertEquals(405, answer.statusCode());
    assertEquals("GET, HEAD, POST", answer.headers().firstValue("Allow").orElseThrow());
    assertTrue(detail(answer).contains("Allowed: GET, HEAD, POST."));
  }

  @ParameterizedTest
  @ValueSource(strings = {"api/v1/tasks/99", "api/v1/tasks/x", "api/v1/robots/none", "api/v1/no"})
  void whatIsNotThereIsAProblem(String path) {
    HttpResponse<String> answer = get(path);

    assertEquals(404, answer.statusCode());
    assertEquals(404, JSON.readTree(answer.body()).get("status").asInt());
  }

  @Test
  void aSessionWritesWithItsToken() {
    try (TestClient clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      assertEquals(201, clerk.postJson("api/v1/tasks", GOOD_TASK).statusCode());
    }
  }

  @Test
  void aTokenThatIsNoneOpensNothing() {
    HttpResponse<String> answer =
        visitor.send(
            visitor.request("api/v1/map").header("Authorization", "Bearer guessed").build());

    assertEquals(401, answer.statusCode());
    assertEquals("Bearer", answer.headers().firstValue("WWW-Authenticate").orElseThrow());
  }
}
