package org.toqa.web.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.accounts.Secret;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What tokens may do, how they are made, and that none makes another. */
class TokensTest extends WebServerTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final Pattern SECRET =
      Pattern.compile("<code class=\"secret\" dir=\"ltr\">([^<]+)</code>");
  private static final String TASK =
      "{\"name\":\"box\",\"load\":1,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":9,\"y\":1}}";

  @ParameterizedTest
  @CsvSource({
    // scope, GET tasks, POST a task, GET metrics, GET users, POST fleet/pause
    "read,    200, 403, 403, 403, 403",
    "tasks,   403, 422, 403, 403, 403",
    "manage,  403, 403, 403, 200, 200",
    "metrics, 403, 403, 200, 403, 403"
  })
  void aTokenDoesWhatItWasMadeFor(
      String scope, int read, int task, int metrics, int users, int pause) {
    String token = token(manager, id("Max"), scope);

    assertEquals(read, send(token, "GET", "api/v1/tasks", "").statusCode());
    assertEquals(task, send(token, "POST", "api/v1/tasks", "{}").statusCode());
    assertEquals(metrics, send(token, "GET", "api/v1/metrics", "").statusCode());
    assertEquals(users, send(token, "GET", "api/v1/users", "").statusCode());
    assertEquals(pause, send(token, "POST", "api/v1/fleet/pause", "").statusCode());
    manager.postJson("api/v1/fleet/resume", "");
    HttpResponse<String> refused = send(token, "GET", "map", "");
    assertEquals(403, refused.statusCode(), "pages are for people");
    assertEquals(204, send(token, "DELETE", "api/v1/session", "").statusCode(), "its own end");
  }

  @Test
  void aTokenMayNoMoreThanItsUser() {
    String token = token(clerk, id("Clara"), "manage");

    HttpResponse<String> refused = send(token, "POST", "api/v1/users", "{}");
    assertEquals(403, refused.statusCode());
    assertTrue(refused.body().contains("manager"), refused.body());
  }

  @Test
  void aRefusedTokenIsToldWhichScopeIsMissing() {
    HttpResponse<String> refused =
        send(token(manager, id("Max"), "metrics"), "POST", "api/v1/tasks", TASK);

    assertEquals(403, refused.statusCode());
    assertTrue(refused.body().contains("scope tasks"), refused.body());
  }

  @Test
  void neitherATokenNorALoginOfAProgramMakesATokenByAnyRoad() {
    long max = id("Max");
    String order = order("read", WebTestServer.PASSWORD);
    for (String bearer :
        new String[] {token(manager, max, "read", "tasks", "manage", "metrics"), login("Max")}) {
      int before = tokenCount(max);
      assertEquals(
          403, send(bearer, "POST", "api/v1/users/" + max + "/tokens", order).statusCode());
      // with a cookie of its own making, from which the token of forms follows
      String secret = "x".repeat(43);
      HttpResponse<String> byForm =
          anonymous.send(
              anonymous
                  .request("users/" + max + "/tokens")
                  .header("Authorization", "Bearer " + bearer)
                  .header("Cookie", "toqa-session=" + secret)
                  .header("Content-Type", "application/x-www-form-urlencoded")
                  .POST(
                      BodyPublishers.ofString(
                          "tokenName=thief&days=9&scopes=read&password="
                              + WebTestServer.PASSWORD.replace(' ', '+')
                              + "&_csrf="
                              + Secret.hash("csrf " + secret)))
                  .build());
      assertEquals(403, byForm.statusCode());
      assertEquals(before, tokenCount(max));
    }
  }

  @Test
  void aTokenTakesThePasswordAgain() {
    long clara = id("Clara");
    int before = tokenCount(clara);
    String path = "api/v1/users/" + clara + "/tokens";

    assertEquals(422, clerk.postJson(path, order("read", "not her password")).statusCode());
    assertEquals(
        422,
        clerk.postJson(path, "{\"name\":\"ci\",\"days\":1,\"scopes\":[\"read\"]}").statusCode());
    assertEquals(
        422,
        clerk
            .post(
                "users/" + clara + "/tokens",
                Map.of("tokenName", "ci", "days", "7", "scopes", "read"))
            .statusCode());
    assertEquals(before, tokenCount(clara));
    assertEquals(201, clerk.postJson(path, order("read", WebTestServer.PASSWORD)).statusCode());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "everything", "READ", "read\",\"all"})
  void aTokenHasAtLeastOneKnownScope(String scope) {
    String body = order(scope, WebTestServer.PASSWORD).replace("[\"\"]", "[]");

    assertEquals(422, clerk.postJson("api/v1/users/" + id("Clara") + "/tokens", body).statusCode());
  }

  @Test
  void aReloadAfterAFormMakesNothingAgainAndShowsTheSecretNoMore() {
    long clara = id("Clara");
    int before = tokenCount(clara);

    HttpResponse<String> made =
        clerk.post(
            "users/" + clara + "/tokens",
            Map.of(
                "tokenName",
                "ci",
                "days",
                "7",
                "scopes",
                "read",
                "password",
                WebTestServer.PASSWORD));

    assertEquals(303, made.statusCode());
    String page = made.headers().firstValue("Location").orElseThrow().substring(1);
    Matcher secret = SECRET.matcher(clerk.get(page).body());
    assertTrue(secret.find());
    assertEquals(200, send(secret.group(1), "GET", "api/v1/tasks", "").statusCode());
    assertFalse(SECRET.matcher(clerk.get(page).body()).find(), "shown once");
    assertEquals(before + 1, tokenCount(clara));

    HttpResponse<String> link = manager.post("users/" + clara + "/reset-link", Map.of());
    assertEquals(303, link.statusCode());
    assertTrue(
        SECRET
            .matcher(
                manager
                    .get(link.headers().firstValue("Location").orElseThrow().substring(1))
                    .body())
            .find());
  }

  @ParameterizedTest
  @CsvSource({
    "users/2/tokens, /users/2",
    "users/2/reset-link, /users/2",
    "users/2/password, /users/2",
    "users/2/delete, /users/2",
    "tasks/1/hold, /tasks/1",
    "fleet/pause, /",
    "logout, /"
  })
  void theAddressOfAFormLeadsToItsPage(String form, String page) {
    HttpResponse<String> answer = manager.get(form);

    assertEquals(303, answer.statusCode());
    assertEquals(page, answer.headers().firstValue("Location").orElseThrow());
    assertEquals(405, manager.send("PUT", form).statusCode());
  }

  private long id(String name) {
    return server.accounts().accountByName(name).orElseThrow().id();
  }

  private int tokenCount(long user) {
    int count = 0;
    for (JsonNode session :
        JSON.readTree(manager.get("api/v1/users/" + user + "/sessions").body())) {
      count += session.get("name").isNull() ? 0 : 1;
    }
    return count;
  }

  private static String order(String scopes, String password) {
    return "{\"name\":\"ci\",\"days\":1,\"scopes\":[\"%s\"],\"password\":\"%s\"}"
        .formatted(scopes, password);
  }

  private static String token(TestClient user, long id, String... scopes) {
    HttpResponse<String> made =
        user.postJson(
            "api/v1/users/" + id + "/tokens",
            order(String.join("\",\"", scopes), WebTestServer.PASSWORD));
    assertEquals(201, made.statusCode(), made.body());
    return JSON.readTree(made.body()).get("token").stringValue();
  }

  private String login(String name) {
    HttpResponse<String> answer =
        anonymous.postJson(
            "api/v1/session",
            "{\"name\":\"%s\",\"password\":\"%s\"}".formatted(name, WebTestServer.PASSWORD));
    return JSON.readTree(answer.body()).get("token").stringValue();
  }

  private HttpResponse<String> send(String token, String method, String path, String body) {
    return anonymous.send(
        anonymous
            .request(path)
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .method(method, BodyPublishers.ofString(body))
            .build());
  }
}
