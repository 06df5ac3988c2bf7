package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.CheckRefusedException.Reason;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/**
 * What people are told of orders that the fleet does not check or store: in the API and on the
 * pages.
 */
class ChecksRefusedTest {
  private static final String TASK =
      """
      {"name": "box", "load": 1, "start": {"station": "Dock A"}, "goal": {"station": "Shelf 3"}}
      """;
  private static final String TABLE = "name,load,start,goal\nbox,1,Dock A,Shelf 3\n";

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
  void whoHasTooManyCheckedAtOnceIsToldToWait() {
    server.fleet().refuseChecks(Reason.TOO_MANY);

    for (String path : List.of("api/v1/tasks", "api/v1/tasks/preview")) {
      HttpResponse<String> refused = clerk.postJson(path, TASK);

      assertEquals(429, refused.statusCode(), path);
      assertEquals("1", refused.headers().firstValue("Retry-After").orElse(""));
      assertTrue(refused.body().contains("Nothing was accepted: send this one again"), path);
    }
    HttpResponse<String> inArabic =
        clerk.send(
            clerk
                .request("api/v1/tasks")
                .header("Accept-Language", "ar")
                .header("Content-Type", "application/json")
                .header("X-CSRF-Token", clerk.csrf())
                .POST(BodyPublishers.ofString(TASK))
                .build());
    assertTrue(inArabic.body().contains("لم يُقبل شيء"), inArabic::body);
    assertEquals(List.of(), server.fleet().latest().tasks());
  }

  @Test
  void whatTookTooLongIsToldSo() {
    server.fleet().refuseChecks(Reason.OUT_OF_TIME);

    for (String path : List.of("api/v1/tasks", "api/v1/tasks/preview")) {
      HttpResponse<String> refused = clerk.postJson(path, TASK);

      assertEquals(503, refused.statusCode(), path);
      assertEquals("5", refused.headers().firstValue("Retry-After").orElse(""));
      assertTrue(refused.body().contains("took too long to check, and nothing was accepted"), path);
    }
  }

  @Test
  void theFormIsShownAgainWithWhatWasEntered() {
    server.fleet().refuseChecks(Reason.TOO_MANY);

    HttpResponse<String> refused =
        clerk.post(
            "tasks/new",
            Map.of(
                "name", "My box", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3"));

    assertEquals(429, refused.statusCode());
    assertTrue(refused.body().contains("Nothing was accepted: send this one again"), refused::body);
    assertTrue(refused.body().contains("My box"), refused::body);
  }

  @Test
  void whoIsDeletedMeanwhileIsLedToTheLogin() throws Exception {
    server.fleet().refuseOrderers();
    Map<String, String> form =
        Map.of("name", "box", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3");

    for (Map<String, String> fields : List.of(form, with(form, "pieces", "2"))) {
      HttpResponse<String> refused = clerk.post("tasks/new", fields);

      assertEquals(303, refused.statusCode(), refused::body);
      assertEquals("/", refused.headers().firstValue("Location").orElse(""));
    }
    HttpResponse<String> ofTable =
        clerk.postFile(
            "tasks/import",
            Map.of("zone", "UTC"),
            "tasks.csv",
            TABLE.getBytes(StandardCharsets.UTF_8));
    assertEquals(303, ofTable.statusCode(), ofTable::body);
    HttpResponse<String> byApi = clerk.postJson("api/v1/tasks", TASK);
    assertEquals(401, byApi.statusCode());
    assertTrue(byApi.body().contains("Log in first"), byApi::body);
  }

  private static Map<String, String> with(Map<String, String> fields, String field, String value) {
    Map<String, String> all = new HashMap<>(fields);
    all.put(field, value);
    return all;
  }

  @Test
  void aTableIsSentAgainLater() {
    server.fleet().refuseChecks(Reason.OUT_OF_TIME);

    HttpResponse<String> refused =
        clerk.postFile(
            "tasks/import",
            Map.of("zone", "UTC"),
            "tasks.csv",
            TABLE.getBytes(StandardCharsets.UTF_8));

    assertEquals(503, refused.statusCode());
    assertTrue(refused.body().contains("took too long to check"), refused::body);
  }
}
