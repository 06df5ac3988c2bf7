package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventRecord;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.access.Permission;

/** Every route for every kind of visitor, and the tricks that are tried. */
class AccessTest {
  private static WebTestServer server;
  private static TestClient anonymous;
  private static TestClient clerk;
  private static TestClient manager;

  @BeforeAll
  static void start() throws Exception {
    server = WebTestServer.start();
    anonymous = new TestClient(server.root());
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
    manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
  }

  @AfterAll
  static void stop() throws Exception {
    anonymous.close();
    clerk.close();
    manager.close();
    server.close();
  }

  /** All but those that sign out: whoever uses them is not signed in for the next. */
  static Stream<Route> routes() {
    return Routes.all().stream().filter(route -> !isSignOut(route));
  }

  private static boolean isSignOut(Route route) {
    return route.path().equals("/logout")
        || (route.path().equals("/api/v1/session") && route.method().equals("DELETE"));
  }

  @ParameterizedTest
  @MethodSource("routes")
  void everyRouteChecksItsPermission(Route route) {
    boolean closedToStrangers = route.permission() != Permission.ANONYMOUS;

    int ofStranger = status(anonymous, route);
    int ofClerk = status(clerk, route);
    int ofManager = status(manager, route);

    if (closedToStrangers) {
      // a page sends to the login, the API says 401
      assertEquals(route.isApi() ? 401 : 303, ofStranger);
      if (!route.isApi()) {
        assertTrue(locationFor(anonymous, route).startsWith("/"), "to the login");
      }
    } else {
      assertPassed(ofStranger);
    }
    if (route.permission() == Permission.MANAGER) {
      assertEquals(403, ofClerk);
    } else {
      assertPassed(ofClerk);
    }
    assertPassed(ofManager);
  }

  @ParameterizedTest
  @MethodSource("routes")
  void noRouteAcceptsAWriteWithoutTheCsrfToken(Route route) {
    if (route.method().equals("GET")
        || (route.isApi()
            && route.permission() == Permission.ANONYMOUS)) { // those take a secret of another kind
      return;
    }
    HttpResponse<String> answer =
        manager.send(
            manager
                .request(path(route))
                .header(
                    "Content-Type",
                    route.isApi() ? "application/json" : "application/x-www-form-urlencoded")
                .header("X-CSRF-Token", "guessed")
                .method(
                    route.method(), BodyPublishers.ofString(route.isApi() ? "{}" : "_csrf=guessed"))
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
    for (String asset : new String[] {"toqa.css", "pico/pico.blue.min.css", "icons.svg"}) {
      assertEquals(200, anonymous.get("assets/" + asset).statusCode(), asset);
    }
    assertEquals(
        "text/javascript;charset=UTF-8",
        anonymous.get("assets/js/map.js").headers().firstValue("Content-Type").orElseThrow());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "map", "assets/toqa.css", "api/v1/map", "nothing"})
  void everyAnswerHasTheSecurityHeaders(String path) {
    HttpResponse<String> answer = clerk.get(path);

    String policy = answer.headers().firstValue("Content-Security-Policy").orElseThrow();
    assertTrue(policy.contains("default-src 'self'"));
    assertTrue(policy.contains("frame-ancestors 'none'"));
    assertFalse(policy.contains("unsafe"));
    assertEquals("nosniff", answer.headers().firstValue("X-Content-Type-Options").orElseThrow());
    assertEquals("same-origin", answer.headers().firstValue("Referrer-Policy").orElseThrow());
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
  void theSessionsIdChangesAtLoginAndItsCookieIsKeptFromScripts() {
    try (TestClient visitor = new TestClient(server.root())) {
      String before = sessionCookie(visitor.get(""));
      HttpResponse<String> answer =
          visitor.post("", Map.of("name", WebTestServer.CLERK, "password", WebTestServer.PASSWORD));

      String after = sessionCookie(answer);
      assertNotEquals(value(before), value(after));
      assertTrue(after.contains("HttpOnly"), after);
      assertTrue(after.contains("SameSite=Lax"), after);
      assertEquals("/map", answer.headers().firstValue("Location").orElseThrow());
    }
  }

  @Test
  void aLoginGoesToThePageThatWasAskedFor() {
    try (TestClient visitor = new TestClient(server.root())) {
      String login = visitor.get("tasks/7").headers().firstValue("Location").orElseThrow();
      assertEquals("/?next=%2Ftasks%2F7", login);
      assertTrue(visitor.get("?next=%2Ftasks%2F7").body().contains("value=\"/tasks/7\""));

      assertEquals("/tasks/7", destination(visitor, "/tasks/7"));
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "//evil.example",
        "https://evil.example/",
        "/\\evil.example",
        "/api/v1/robots",
        "x"
      })
  void aLoginGoesNowhereElse(String next) {
    try (TestClient visitor = new TestClient(server.root())) {
      assertEquals("/map", destination(visitor, next));
    }
  }

  @ParameterizedTest
  @CsvSource({"Clara, wrong password 1", "nobody, a long enough password", "Clara, ''"})
  void aWrongLoginSaysNotWhichPartIsWrong(String name, String password) {
    try (TestClient visitor = new TestClient(server.root())) {
      HttpResponse<String> answer = visitor.post("", Map.of("name", name, "password", password));

      assertEquals(422, answer.statusCode());
      assertTrue(
          answer.body().contains("Name or password is wrong.")
              || answer.body().contains("Enter your password."));
      assertFalse(answer.body().contains("<span>Log-out</span>"));
    }
  }

  @Test
  void afterSomeFailuresANameIsSlowed() {
    try (TestClient visitor = new TestClient(server.root())) {
      for (int i = 0; i < 5; i++) {
        HttpResponse<String> answer = visitor.post("", Map.of("name", "victim", "password", "x"));
        assertTrue(answer.body().contains("Name or password is wrong."));
      }

      HttpResponse<String> answer = visitor.post("", Map.of("name", "VICTIM", "password", "x"));

      assertTrue(answer.body().contains("Too many attempts failed. Try again in 1 s."));
      assertEquals("1", answer.headers().firstValue("Retry-After").orElseThrow());
    }
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
      assertTrue(answer.body().contains("toqa.css"), answer.body());
      assertFalse(answer.body().contains("Exception"), answer.body());
    }
  }

  @Test
  void aPageThatIsNotThereMakesNoSession() {
    try (TestClient visitor = new TestClient(server.root())) {
      assertEquals(List.of(), visitor.get("nothing").headers().allValues("Set-Cookie"));
    }
  }

  @Test
  void aLogoutEndsTheSession() {
    try (TestClient visitor = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      assertEquals(303, visitor.post("logout", Map.of()).statusCode());

      assertEquals(303, visitor.get("map").statusCode());
      assertEquals(401, visitor.get("api/v1/map").statusCode());
    }
  }

  @Test
  void aNewPasswordEndsTheUsersOtherSessions() {
    server.accounts().add("Nora", hash(), Role.CLERK, EventRecord.SYSTEM);
    try (TestClient here = TestClient.signedIn(server.root(), "Nora");
        TestClient elsewhere = TestClient.signedIn(server.root(), "Nora")) {
      long nora = server.accounts().accountByName("nora").orElseThrow().id();
      Map<String, String> form =
          Map.of("old", WebTestServer.PASSWORD, "password", "quite another password");

      assertEquals(303, here.post("users/" + nora + "/password", form).statusCode());

      assertEquals(200, here.get("map").statusCode());
      assertEquals(303, elsewhere.get("map").statusCode());
      assertEquals(422, here.post("users/" + nora + "/password", form).statusCode(), "old one");
    }
  }

  @Test
  void aClerkChangesNobodyElsesPassword() {
    long max = server.accounts().accountByName(WebTestServer.MANAGER).orElseThrow().id();

    HttpResponse<String> answer =
        clerk.post("users/" + max + "/password", Map.of("password", "taken over now"));

    assertEquals(403, answer.statusCode());
    assertEquals(200, manager.get("map").statusCode());
  }

  @Test
  void aDeletedUserIsOutAtOnce() {
    server.accounts().add("Gone", hash(), Role.MANAGER, EventRecord.SYSTEM);
    try (TestClient gone = TestClient.signedIn(server.root(), "Gone")) {
      server
          .accounts()
          .delete(server.accounts().accountByName("gone").orElseThrow().id(), EventRecord.SYSTEM);

      assertEquals(303, gone.get("map").statusCode());
    }
  }

  @Test
  void aDisabledUserIsOutAtOnceAndInAgainWhenAManagerSaysSo() {
    long idle = server.accounts().add("Idle", hash(), Role.CLERK, "Max").orElseThrow().id();
    try (TestClient user = TestClient.signedIn(server.root(), "Idle")) {
      Map<String, String> disabled = Map.of("role", "CLERK", "disabled", "on");
      assertEquals(303, manager.post("users/" + idle + "/change", disabled).statusCode());

      assertEquals(303, user.get("map").statusCode());
      Map<String, String> login = Map.of("name", "Idle", "password", WebTestServer.PASSWORD);
      HttpResponse<String> refused = user.post("", login);
      assertEquals(422, refused.statusCode());
      assertTrue(refused.body().contains("A manager has disabled this user."));

      assertEquals(
          303, manager.post("users/" + idle + "/change", Map.of("role", "MANAGER")).statusCode());
      assertEquals(303, user.post("", login).statusCode());
      assertTrue(user.get("users").body().contains("Add a user"), "a manager now");
    }
  }

  @Test
  void clerksDoNotSeeWhatManagersDoWithUsers() {
    server.accounts().add("Secret", hash(), Role.CLERK, "Max");

    assertTrue(manager.get("history?kind=user").body().contains("added the user Secret"));
    assertFalse(clerk.get("history").body().contains("added the user Secret"));
    assertFalse(clerk.get("history?kind=user").body().contains("added the user Secret"));
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

  @Test
  void nobodyOverwritesWhatAnotherChangedMeanwhile() {
    long id = server.accounts().add("Etta", hash(), Role.CLERK, "Max").orElseThrow().id();
    String path = "api/v1/users/" + id;
    String read = manager.get(path).headers().firstValue("ETag").orElseThrow();
    assertEquals(200, put(path, "{\"role\":\"MANAGER\",\"disabled\":false}", read));
    assertEquals(412, put(path, "{\"role\":\"CLERK\",\"disabled\":true}", read));
    assertEquals(Role.MANAGER, server.accounts().account(id).orElseThrow().role());
    assertEquals(200, put(path, "{\"role\":\"CLERK\",\"disabled\":false}", "\"x\", *"));
    assertEquals(200, put(path, "{\"role\":\"MANAGER\",\"disabled\":false}", read), "as it was");
  }

  private static int put(String path, String body, String version) {
    return manager
        .send(
            manager
                .request(path)
                .header("Content-Type", "application/json")
                .header("X-CSRF-Token", manager.csrf())
                .header("If-Match", version)
                .PUT(BodyPublishers.ofString(body))
                .build())
        .statusCode();
  }

  private static String hash() {
    return server.accounts().accountByName(WebTestServer.CLERK).orElseThrow().passwordHash();
  }

  private static String destination(TestClient client, String next) {
    return client
        .post(
            "",
            Map.of("name", WebTestServer.CLERK, "password", WebTestServer.PASSWORD, "next", next))
        .headers()
        .firstValue("Location")
        .orElseThrow();
  }

  private static String sessionCookie(HttpResponse<?> answer) {
    return answer.headers().allValues("Set-Cookie").stream()
        .filter(cookie -> cookie.startsWith("toqa-session="))
        .findFirst()
        .orElseThrow();
  }

  private static String value(String cookie) {
    return cookie.split(";", 2)[0];
  }

  /** Passed means: whatever the handler then said, no permission was missing. */
  private static void assertPassed(int status) {
    assertTrue(
        Set.of(200, 303, 404, 410, 415, 422).contains(status), "It was refused: " + status);
  }

  private static int status(TestClient client, Route route) {
    return response(client, route).statusCode();
  }

  private static String locationFor(TestClient client, Route route) {
    return response(client, route).headers().firstValue("Location").orElseThrow();
  }

  private static HttpResponse<String> response(TestClient client, Route route) {
    if (route.method().equals("GET")) {
      return client.send("HEAD", path(route));
    }
    return route.isApi()
        ? client.sendJson(route.method(), path(route), "{}")
        : client.post(path(route), Map.of());
  }

  private static String path(Route route) {
    return route
        .path()
        .substring(1)
        .replace("{id}", "999999")
        .replace("{language}", "en")
        .replace("{name}", "none")
        .replace("{session}", "1")
        .replace("{floor}", "none")
        .replace("*", "toqa.css");
  }
}
