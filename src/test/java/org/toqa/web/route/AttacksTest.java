package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.net.URLEncoder;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/**
 * What attackers try, but for forged forms, which are in {@code AccessTest}, and planted sessions
 * and guessed passwords, which are in {@code LoginTest}.
 */
class AttacksTest {
  private static final String SCRIPT = "<script>alert(1)</script>";

  private static final Map<String, List<String>> FORMS =
      Map.of(
          "",
          List.of("name", "password", "next"),
          "forgotten",
          List.of("user"),
          "reset",
          List.of("secret", "password"),
          "tasks/new",
          List.of(
              "name",
              "load",
              "startStation",
              "startX",
              "goalStation",
              "goalX",
              "floor",
              "priority",
              "deadline",
              "zone",
              "length",
              "width",
              "when",
              "first",
              "everyMinutes",
              "weekday",
              "time",
              "until",
              "idempotencyKey"),
          "robots",
          List.of("name", "host", "port", "maxLoad", "parking", "code"),
          "robots/r1/locate",
          List.of("x", "y", "heading"),
          "robots/r1/change",
          List.of("host", "port", "maxLoad", "parking"),
          "robots/r1/pair",
          List.of("host", "port", "code"),
          "users",
          List.of("name", "password", "role", "email"),
          "users/1/tokens",
          List.of("tokenName", "days"));

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
  void whatIsTypedIsTextInEveryFieldAndEveryQuery(String attack) {
    FORMS.forEach(
        (form, fields) ->
            fields.forEach(
                field -> {
                  Map<String, String> sent = new HashMap<>(Map.of(field, attack));
                  assertHarmless(form + " " + field, attack, manager.post(form, sent));
                }));
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

  @Test
  void aScriptThatIsStoredIsShownAsText() {
    String body =
        """
        {"name":"%s","load":1,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}}
        """
            .formatted(SCRIPT);
    assertEquals(201, manager.postJson("api/v1/tasks", body).statusCode());
    assertEquals(
        200, manager.post("users/2/tokens", Map.of("tokenName", SCRIPT, "days", "1")).statusCode());

    for (String page : List.of("map", "tasks", "tasks/1", "users/2", "history", "statistics")) {
      HttpResponse<String> answer = manager.get(page);
      assertEquals(200, answer.statusCode(), page);
      assertFalse(answer.body().contains(SCRIPT), page);
    }
    assertTrue(manager.get("tasks/1").body().contains("&lt;script&gt;"));
    assertTrue(
        manager
            .get("api/v1/tasks/1")
            .headers()
            .firstValue("Content-Type")
            .orElse("")
            .startsWith("application/json"));
  }

  @Test
  void whoSendsHalfARequestKeepsNobodyWaiting() throws IOException {
    List<Socket> slow = new ArrayList<>();
    try {
      for (int i = 0; i < 300; i++) {
        Socket socket = new Socket(server.root().getHost(), server.root().getPort());
        slow.add(socket);
        socket
            .getOutputStream()
            .write("POST / HTTP/1.1\r\nHost: x\r\nConte".getBytes(StandardCharsets.US_ASCII));
      }
      assertEquals(200, manager.get("map").statusCode());
    } finally {
      for (Socket socket : slow) {
        socket.close();
      }
    }
  }

  @Test
  void aThousandReadersOfLiveEventsKeepNobodyWaiting() throws Exception {
    String cookie =
        manager
            .post("", Map.of("name", WebTestServer.CLERK, "password", WebTestServer.PASSWORD))
            .headers()
            .firstValue("Set-Cookie")
            .orElseThrow()
            .split(";", 2)[0];
    List<Socket> readers = new ArrayList<>();
    try {
      for (int i = 0; i < 1000; i++) {
        Socket socket = new Socket(server.root().getHost(), server.root().getPort());
        readers.add(socket); // and never reads
        socket
            .getOutputStream()
            .write(
                "GET /api/v1/events HTTP/1.1\r\nHost: x\r\nCookie: %s\r\n\r\n"
                    .formatted(cookie)
                    .getBytes(StandardCharsets.US_ASCII));
      }
      try (TestClient other = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
        long before = server.fleet().latest().version();
        server.fleet().changeFloor(Hall.crowdedFloor());
        assertTrue(server.fleet().latest().version() > before);
        assertEquals(200, other.get("map").statusCode());
        assertEquals(200, other.get("api/v1/robots").statusCode());
      }
    } finally {
      for (Socket reader : readers) {
        reader.close();
      }
    }
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
