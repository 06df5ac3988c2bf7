package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import org.toqa.web.access.Permission;

/** Every route against every kind of client, and what every answer must have. */
class AccessTest extends WebServerTest {
  /** All but those that sign out: after them, the client is anonymous. */
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

  /** Whatever the servlet then answered, no permission was missing. */
  private static void assertPassed(int status) {
    assertTrue(
        Set.of(200, 303, 404, 410, 415, 422).contains(status),
        "The permission was missing: " + status);
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
        .replace("*", "css/base.css");
  }
}
