package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URLEncoder;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/**
 * What attackers put into addresses. What they put into forms and orders is tried on the whole
 * server, in {@code FormAttacksTest} and {@code OrderAttacksTest}; forged forms are in {@code
 * AccessTest}, planted sessions and guessed passwords in {@code LoginTest}.
 */
class QueryAttacksTest {
  private static final String SCRIPT = "<script>alert(1)</script>";

  private static final Map<String, List<String>> QUERIES =
      Map.ofEntries(
          Map.entry("", List.of("next", "done")),
          Map.entry("reset", List.of("secret")),
          Map.entry(
              "tasks",
              List.of(
                  "page", "imported", "state", "robot", "user", "text", "from", "until", "sort")),
          Map.entry("users", List.of("done")),
          Map.entry(
              "history",
              List.of("robot", "task", "user", "kind", "from", "until", "zone", "before")),
          Map.entry("statistics", List.of("period", "from", "to", "zone")),
          Map.entry(
              "api/v1/history",
              List.of("robot", "task", "user", "kind", "since", "until", "limit", "before")),
          Map.entry("api/v1/statistics", List.of("period", "from", "to", "zone")),
          Map.entry(
              "api/v1/tasks",
              List.of(
                  "offset", "limit", "state", "robot", "user", "text", "from", "until", "sort")),
          Map.entry("api/v1/events", List.of("changes")),
          Map.entry("api/v1/map", List.of("floor")),
          Map.entry("api/v1/tracks", List.of("floor", "from", "until")));

  private WebTestServer server;
  private TestClient manager;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.start();
    manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
    server.fleet().changeFloor(Hall.crowdedFloor());
  }

  @AfterEach
  void stop() throws Exception {
    manager.close();
    server.close();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        SCRIPT,
        "\"><img src=x onerror=alert(1)>",
        "'; drop table users; --",
        "' or '1'='1",
        "\\",
        "${7*7}#{7*7}",
        "%00",
        "\u0000",
        "../../../etc/passwd",
        "{0}",
        "\ud83d\ude80\u202e"
      })
  void whatIsAskedIsTextInEveryQuery(String attack) {
    QUERIES.forEach(
        (page, parameters) ->
            parameters.forEach(
                parameter -> {
                  String query =
                      "?" + parameter + "=" + URLEncoder.encode(attack, StandardCharsets.UTF_8);
                  assertHarmless(page + query, attack, manager.get(page + query));
                }));

    assertTrue(server.accounts().accountByName(WebTestServer.CLERK).isPresent());
    assertEquals(200, manager.get("map").statusCode());
  }

  private static void assertHarmless(String where, String attack, HttpResponse<String> answer) {
    assertTrue(answer.statusCode() < 500, where + " answered " + answer.statusCode());
    String body = answer.body();
    if (attack.contains("<")) {
      assertFalse(body.contains(attack), where + " shows it raw");
    }
    assertFalse(body.contains("49#{7*7}") || body.contains("#49"), where + " evaluates it");
    assertFalse(body.contains("Exception"), where + " shows a stack trace");
    assertFalse(body.contains("root:"), where + " shows a file");
  }
}
