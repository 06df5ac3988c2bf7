package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;

/** Sessions from the login to the logout. */
class LoginTest extends WebServerTest {
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
          answer.body().contains("Wrong name or password.")
              || answer.body().contains("Enter your password."));
      assertFalse(answer.body().contains("<span>Log out</span>"));
    }
  }

  @Test
  void afterSomeFailuresANameIsSlowed() {
    try (TestClient visitor = new TestClient(server.root())) {
      for (int i = 0; i < 5; i++) {
        HttpResponse<String> answer = visitor.post("", Map.of("name", "victim", "password", "x"));
        assertTrue(answer.body().contains("Wrong name or password."));
      }

      HttpResponse<String> answer = visitor.post("", Map.of("name", "VICTIM", "password", "x"));

      assertTrue(answer.body().contains("Too many failed attempts. Try again in 1 s."));
      assertEquals("1", answer.headers().firstValue("Retry-After").orElseThrow());
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
}
