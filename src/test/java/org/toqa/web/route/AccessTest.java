package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.http.HttpHeaders;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.accounts.Account;
import org.toqa.accounts.Scope;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.json.JsonMapper;

/** Every route against every kind of client, and what every answer must have. */
class AccessTest extends WebServerTest {
  /**
   * Who may do what, written by hand: a method, a path, and the status for a client that is not
   * signed in, a clerk and a manager. Each sends an order without fields, for what does not exist.
   */
  private static final Path RIGHTS = Path.of("src/test/resources/web/rights.txt");

  /** Whoever sends these proves himself by what is in them. */
  private static final Set<String> WITHOUT_TOKEN =
      Set.of("/api/v1/session", "/api/v1/forgotten-password", "/api/v1/reset-password");

  /** Beside the policy of contents, in every answer. */
  private static final Map<String, String> SECURITY_HEADERS =
      Map.of(
          "X-Content-Type-Options", "nosniff",
          "X-Frame-Options", "DENY",
          "Referrer-Policy", "same-origin",
          "Cross-Origin-Opener-Policy", "same-origin",
          "Cross-Origin-Resource-Policy", "same-origin");

  private static final JsonMapper JSON = new JsonMapper();

  private final Map<Scope, String> tokens = new EnumMap<>(Scope.class);

  /** A line of the table. */
  record Right(
      String method,
      String path,
      String ofAnonymous,
      String ofClerk,
      String ofManager,
      String scope) {

    boolean needsScope() {
      return Scope.ofWord(scope).isPresent();
    }

    boolean isApi() {
      return path.startsWith("/api/v1/");
    }

    boolean needsToken() {
      return !method.equals("GET") && !(method.equals("POST") && WITHOUT_TOKEN.contains(path));
    }

    boolean endsSession() {
      return path.equals("/logout") || (path.equals("/api/v1/session") && method.equals("DELETE"));
    }
  }

  static List<Right> rights() throws IOException {
    return Files.readAllLines(RIGHTS).stream()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .map(line -> line.split(" +"))
        .map(
            word ->
                new Right(
                    word[0], word[1], word[2], word[3], word[4], word.length > 5 ? word[5] : ""))
        .toList();
  }

  @Test
  void everyRouteHasItsLineInTheTable() throws IOException {
    assertEquals(
        Routes.all().stream().map(route -> route.method() + " " + route.path()).sorted().toList(),
        rights().stream().map(right -> right.method() + " " + right.path()).sorted().toList());
  }

  @ParameterizedTest
  @MethodSource("rights")
  void everyRouteIsForThoseOfTheTable(Right right) {
    assertEquals(
        List.of(right.ofAnonymous(), right.ofClerk(), right.ofManager()),
        Stream.of(
                anonymous,
                clientFor(clerk, WebTestServer.CLERK, right),
                clientFor(manager, WebTestServer.MANAGER, right))
            .map(client -> answer(client, right))
            .toList());
  }

  @Test
  void everyCallOfTheApiSaysWhichTokensOpenIt() throws IOException {
    for (Right right : rights()) {
      assertEquals(right.isApi(), !right.scope().isEmpty(), right.method() + " " + right.path());
    }
  }

  static List<Right> calls() throws IOException {
    return rights().stream().filter(Right::needsScope).toList();
  }

  /** What the token's user may, with the scope of the table and no other. */
  @ParameterizedTest
  @MethodSource("calls")
  void everyCallIsOpenForTokensOfItsScopeOnly(Right right) {
    for (Scope scope : Scope.values()) {
      assertEquals(
          scope.word().equals(right.scope()) ? right.ofManager() : "403",
          String.valueOf(byToken(token(scope), right).statusCode()),
          "with a token for " + scope);
    }
  }

  private HttpResponse<String> byToken(String token, Right right) {
    String method = right.path().equals("/api/v1/events") ? "HEAD" : right.method();
    return anonymous.send(
        anonymous
            .request(path(right))
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .method(
                method,
                right.method().equals("GET")
                    ? BodyPublishers.noBody()
                    : BodyPublishers.ofString("{}"))
            .build());
  }

  /** A token of the manager, of that scope alone. */
  private String token(Scope scope) {
    return tokens.computeIfAbsent(
        scope,
        wanted -> {
          Account max = server.accounts().accountByName(WebTestServer.MANAGER).orElseThrow();
          String order =
              "{\"name\":\"ci\",\"days\":1,\"scopes\":[\"%s\"],\"password\":\"%s\"}"
                  .formatted(wanted.word(), WebTestServer.PASSWORD);
          HttpResponse<String> made =
              manager.postJson("api/v1/users/" + max.id() + "/tokens", order);
          assertEquals(201, made.statusCode(), made.body());
          return JSON.readTree(made.body()).get("token").stringValue();
        });
  }

  /** Whoever signs out is anonymous then. */
  private TestClient clientFor(TestClient shared, String user, Right right) {
    return right.endsSession() ? TestClient.signedIn(server.root(), user) : shared;
  }

  static List<Right> writes() throws IOException {
    return rights().stream().filter(Right::needsToken).toList();
  }

  @ParameterizedTest
  @MethodSource("writes")
  void noRouteAcceptsAWriteWithoutTheCsrfToken(Right right) {
    HttpResponse<String> answer =
        manager.send(
            manager
                .request(path(right))
                .header(
                    "Content-Type",
                    right.isApi() ? "application/json" : "application/x-www-form-urlencoded")
                .header("X-CSRF-Token", "guessed")
                .method(
                    right.method(), BodyPublishers.ofString(right.isApi() ? "{}" : "_csrf=guessed"))
                .build());

    assertEquals(403, answer.statusCode());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "WEB-INF/web.xml",
        "WEB-INF/views/map.jsp",
        "assets/../WEB-INF/web.xml",
        "assets/%2e%2e/WEB-INF/web.xml",
        "assets/..%2fWEB-INF/web.xml",
        "error",
        "META-INF/MANIFEST.MF",
        "assets/",
        "tasks;x=/assets/",
        "TASKS"
      })
  void pathsWithoutARouteAreNotFound(String path) {
    int status = anonymous.get(path).statusCode();

    assertTrue(status == 404 || status == 400 || status == 303, path + " answered " + status);
    assertFalse(anonymous.get(path).body().contains("servlet"), path);
  }

  @Test
  void theStylesheetIsPublic() {
    for (String asset : new String[] {"css/base.css", "pico/pico.blue.min.css", "icons.svg"}) {
      assertEquals(200, anonymous.get("assets/" + asset).statusCode(), asset);
    }
    assertEquals(
        "text/javascript;charset=UTF-8",
        anonymous.get("assets/js/map/map.js").headers().firstValue("Content-Type").orElseThrow());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "map", "assets/css/base.css", "api/v1/map", "nothing"})
  void everyAnswerHasTheSecurityHeaders(String path) {
    HttpHeaders headers = clerk.get(path).headers();

    String policy = headers.firstValue("Content-Security-Policy").orElseThrow();
    assertTrue(policy.contains("default-src 'self'"));
    assertTrue(policy.contains("frame-ancestors 'none'"));
    assertFalse(policy.contains("unsafe"));
    SECURITY_HEADERS.forEach(
        (name, value) -> assertEquals(List.of(value), headers.allValues(name), name));
    assertEquals(
        List.of(path.startsWith("assets/") ? "no-cache" : "no-store"),
        headers.allValues("Cache-Control"),
        "what only a user may see is kept nowhere");
  }

  @ParameterizedTest
  @ValueSource(strings = {"map", "tasks", "tasks/new", "robots", "users", "statistics", "nothing"})
  void noPageHasScriptOrStyleInline(String path) {
    String page = manager.get(path).body();

    assertFalse(page.contains("style="), "style attribute");
    assertFalse(page.contains("<style"), "style element");
    assertFalse(page.matches("(?s).*\\son[a-z]+=.*"), "event attribute");
    assertFalse(page.matches("(?s).*<script(?![^>]*src=).*"), "inline script");
  }

  @Test
  void aFormThatCannotBeReadIsTheSendersFault() {
    for (String body : new String[] {"name=%zz&password=x", "name=" + "x".repeat(3_000_000)}) {
      HttpResponse<String> answer =
          anonymous.send(
              anonymous
                  .request("")
                  .header("Content-Type", "application/x-www-form-urlencoded")
                  .POST(BodyPublishers.ofString(body))
                  .build());

      assertTrue(answer.statusCode() >= 400 && answer.statusCode() < 500, "" + answer.statusCode());
      assertTrue(answer.body().contains("css/base.css"), answer.body());
      assertFalse(answer.body().contains("Exception"), answer.body());
    }
  }

  @Test
  void aRobotIsChangedAndRemoved() {
    assertEquals(
        201,
        manager
            .postJson(
                "api/v1/robots",
                "{\"name\":\"leaving\",\"host\":\"127.0.0.1\",\"port\":7299,\"maxLoad\":5}")
            .statusCode());
    String path = "api/v1/robots/leaving";
    String change = "{\"host\":\"%s\",\"port\":7300,\"maxLoad\":4,\"parking\":null}";
    HttpResponse<String> changed = manager.sendJson("PUT", path, change.formatted("10.0.0.9"));
    assertEquals(200, changed.statusCode());
    assertTrue(changed.body().contains("10.0.0.9"), changed.body());
    assertEquals(422, manager.sendJson("PUT", path, change.formatted("a b")).statusCode());
    assertEquals(403, clerk.sendJson("PUT", path, change.formatted("10.0.0.9")).statusCode());

    assertEquals(409, manager.sendJson("DELETE", path, "").statusCode(), "in service");
    assertEquals(200, manager.postJson(path + "/out-of-service", "").statusCode());
    assertEquals(204, manager.sendJson("DELETE", path, "").statusCode());
    assertEquals(404, manager.get(path).statusCode());
    assertEquals(404, manager.sendJson("DELETE", path, "").statusCode());
  }

  private static String answer(TestClient client, Right right) {
    HttpResponse<String> response = response(client, right);
    String target = response.headers().firstValue("Location").orElse("");
    return target.matches("/(\\?.*)?") ? "login" : String.valueOf(response.statusCode());
  }

  private static HttpResponse<String> response(TestClient client, Right right) {
    if (right.method().equals("GET")) {
      // the stream of events would not end
      return client.send(right.path().equals("/api/v1/events") ? "HEAD" : "GET", path(right));
    }
    return right.isApi()
        ? client.sendJson(right.method(), path(right), "{}")
        : client.post(path(right), Map.of());
  }

  private static String path(Right right) {
    return right
        .path()
        .substring(1)
        .replace("{id}", "999999")
        .replace("{language}", "en")
        .replace("{name}", "none")
        .replace("{session}", "999999")
        .replace("{floor}", "none")
        .replace("*", "css/base.css");
  }
}
