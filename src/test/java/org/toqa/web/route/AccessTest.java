package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.http.HttpHeaders;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.accounts.Scope;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;
import org.toqa.web.route.Rights.Right;
import tools.jackson.databind.json.JsonMapper;

/** Every route against every kind of client, and what every answer must have. */
class AccessTest extends WebServerTest {
  /** Beside the policy of contents, in every answer. */
  private static final Map<String, String> SECURITY_HEADERS =
      Map.of(
          "X-Content-Type-Options", "nosniff",
          "X-Frame-Options", "DENY",
          "Referrer-Policy", "same-origin",
          "Cross-Origin-Opener-Policy", "same-origin",
          "Cross-Origin-Resource-Policy", "same-origin");

  private static final String ADMINISTRATOR = "Ada";
  private static final String VIEWER = "Vera";
  private static final String OPERATOR = "Otto";

  private static final JsonMapper JSON = new JsonMapper();

  private final Map<Scope, String> tokens = new EnumMap<>(Scope.class);

  @Test
  void everyRouteHasItsLineInTheTable() throws IOException {
    assertEquals(
        Routes.all().stream().map(route -> route.method() + " " + route.path()).sorted().toList(),
        Rights.all().stream().map(right -> right.method() + " " + right.path()).sorted().toList());
  }

  private TestClient administrator;
  private TestClient viewer;
  private TestClient operator;

  @BeforeAll
  void addAdministrator() {
    server.addUser(ADMINISTRATOR, null, Role.ADMINISTRATOR);
    administrator = TestClient.signedIn(server.root(), ADMINISTRATOR);
    server.addUser(VIEWER, null, Role.VIEWER);
    viewer = TestClient.signedIn(server.root(), VIEWER);
    server.addUser(OPERATOR, null, Role.OPERATOR);
    operator = TestClient.signedIn(server.root(), OPERATOR);
  }

  @AfterAll
  void closeAdministrator() {
    administrator.close();
    viewer.close();
    operator.close();
  }

  static List<Right> rights() throws IOException {
    return Rights.all();
  }

  @ParameterizedTest
  @MethodSource("rights")
  void everyRouteIsForThoseOfTheTable(Right right) {
    assertEquals(
        List.of(
            right.ofAnonymous(),
            right.ofViewer(),
            right.ofClerk(),
            right.ofOperator(),
            right.ofManager(),
            right.ofAdministrator()),
        Stream.of(
                anonymous,
                clientFor(viewer, VIEWER, right),
                clientFor(clerk, WebTestServer.CLERK, right),
                clientFor(operator, OPERATOR, right),
                clientFor(manager, WebTestServer.MANAGER, right),
                clientFor(administrator, ADMINISTRATOR, right))
            .map(client -> Rights.answer(client, right))
            .toList());
  }

  @Test
  void everyCallOfTheApiSaysWhichTokensOpenIt() throws IOException {
    for (Right right : Rights.all()) {
      assertEquals(right.isApi(), !right.scope().isEmpty(), right.method() + " " + right.path());
    }
  }

  static List<Right> calls() throws IOException {
    return Rights.all().stream().filter(Right::needsScope).toList();
  }

  /** What the token's user may, with the scope of the table and no other. */
  @ParameterizedTest
  @MethodSource("calls")
  void everyCallIsOpenForTokensOfItsScopeOnly(Right right) {
    for (Scope scope : Scope.values()) {
      assertEquals(
          scope.word().equals(right.scope()) ? right.ofAdministrator() : "403",
          String.valueOf(byToken(token(scope), right).statusCode()),
          "with a token for " + scope);
    }
  }

  private HttpResponse<String> byToken(String token, Right right) {
    String method = right.path().equals("/api/v1/events") ? "HEAD" : right.method();
    return anonymous.send(
        anonymous
            .request(Rights.path(right))
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .method(
                method,
                right.method().equals("GET")
                    ? BodyPublishers.noBody()
                    : BodyPublishers.ofString("{}"))
            .build());
  }

  /** A token of the administrator, of that scope alone. */
  private String token(Scope scope) {
    return tokens.computeIfAbsent(
        scope,
        wanted -> {
          Account user = server.accounts().accountByName(ADMINISTRATOR).orElseThrow();
          String order =
              "{\"name\":\"ci\",\"days\":1,\"scopes\":[\"%s\"],\"password\":\"%s\"}"
                  .formatted(wanted.word(), WebTestServer.PASSWORD);
          HttpResponse<String> made =
              administrator.postJson("api/v1/users/" + user.id() + "/tokens", order);
          assertEquals(201, made.statusCode(), made.body());
          return JSON.readTree(made.body()).get("token").stringValue();
        });
  }

  /** Whoever signs out is anonymous then. */
  private TestClient clientFor(TestClient shared, String user, Right right) {
    return right.endsSession() ? TestClient.signedIn(server.root(), user) : shared;
  }

  static List<Right> writes() throws IOException {
    return Rights.all().stream().filter(Right::needsToken).toList();
  }

  @ParameterizedTest
  @MethodSource("writes")
  void noRouteAcceptsAWriteWithoutTheCsrfToken(Right right) {
    HttpResponse<String> answer =
        manager.send(
            manager
                .request(Rights.path(right))
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
  @CsvSource({
    "WEB-INF/web.xml, 404",
    "WEB-INF/views/map.jsp, 404",
    "assets/../WEB-INF/web.xml, 404",
    "assets/%2e%2e/WEB-INF/web.xml, 404",
    "assets/..%2fWEB-INF/web.xml, 400",
    "error, 404",
    "META-INF/MANIFEST.MF, 404",
    "assets/, 404",
    "tasks;x=/assets/, 404",
    "TASKS, 404"
  })
  void pathsWithoutARouteAreNotFound(String path, int status) {
    HttpResponse<String> answer = anonymous.get(path);

    assertEquals(status, answer.statusCode());
    assertFalse(answer.body().contains("servlet"), path);
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
    assertUnreadable(400, "name=%zz&password=x");
    assertUnreadable(413, "name=" + "x".repeat(3_000_000));
  }

  private void assertUnreadable(int status, String form) {
    HttpResponse<String> answer =
        anonymous.send(
            anonymous
                .request("")
                .header("Content-Type", "application/x-www-form-urlencoded")
                .POST(BodyPublishers.ofString(form))
                .build());

    assertEquals(status, answer.statusCode());
    assertTrue(answer.body().contains("css/base.css"), answer.body());
    assertFalse(answer.body().contains("Exception"), answer.body());
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
}
