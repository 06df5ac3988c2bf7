package org.toqa.web.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventRecord;
import org.toqa.web.TestClient;
import org.toqa.web.TestMailbox;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Where users are logged in, their tokens, and how a forgotten password is replaced. */
class SessionsTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final Pattern SECRET =
      Pattern.compile("<code class=\"secret\" dir=\"ltr\">([^<]+)</code>");
  private static final Pattern LINK = Pattern.compile("/reset\\?secret=([A-Za-z0-9_-]{43})");
  private static final String NEW_PASSWORD = "quite another password";

  private static WebTestServer server;
  private static TestClient manager;

  /** Each test has a user of its own. */
  private static int users;

  private String name = "";
  private long id;
  private TestClient user;

  @BeforeAll
  static void start() throws Exception {
    server = WebTestServer.start();
    manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
  }

  @AfterAll
  static void stop() throws Exception {
    manager.close();
    server.close();
  }

  @BeforeEach
  void addUser() {
    name = "Uma" + ++users;
    String hash = server.accounts().accountByName(WebTestServer.CLERK).orElseThrow().passwordHash();
    id =
        server
            .accounts()
            .add(name, name + "@example.org", hash, Role.CLERK, EventRecord.SYSTEM)
            .orElseThrow()
            .id();
    user = TestClient.signedIn(server.root(), name);
  }

  @AfterEach
  void leave() {
    user.close();
  }

  @Test
  void aUserSeesWhereHeIsLoggedInAndEndsTheOtherSession() {
    try (TestClient elsewhere = TestClient.signedIn(server.root(), name)) {
      JsonNode sessions = JSON.readTree(elsewhere.get("api/v1/users/" + id + "/sessions").body());
      assertEquals(2, sessions.size());
      assertEquals("127.0.0.1", sessions.get(0).get("address").stringValue());
      assertTrue(sessions.get(0).get("agent").stringValue().contains("Java"), "as it calls itself");
      long older = Math.min(sessions.get(0).get("id").asLong(), sessions.get(1).get("id").asLong());
      String page = elsewhere.get("users").body();
      assertTrue(page.contains("(current)"));

      assertEquals(
          303,
          elsewhere.post("users/" + id + "/sessions/" + older + "/end", Map.of()).statusCode());

      assertEquals(303, user.get("map").statusCode(), "to the login");
      assertEquals(200, elsewhere.get("map").statusCode());
      HttpResponse<String> again =
          elsewhere.post("users/" + id + "/sessions/" + older + "/end", Map.of());
      assertEquals(422, again.statusCode());
      assertTrue(again.body().contains("There is no such session."));
    }
  }

  @Test
  void nobodyButAManagerEndsAnothersSession() {
    JsonNode sessions = JSON.readTree(user.get("api/v1/users/" + id + "/sessions").body());
    long session = sessions.get(0).get("id").asLong();
    try (TestClient clara = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      long own = server.accounts().accountByName(WebTestServer.CLERK).orElseThrow().id();
      assertEquals(404, clara.get("api/v1/users/" + id + "/sessions").statusCode());
      assertEquals(403, clara.get("users/" + id).statusCode());
      // under her own number it is not hers
      String path = "api/v1/users/" + own + "/sessions/" + session;
      assertEquals(404, clara.sendJson("DELETE", path, "").statusCode());
    }
    assertEquals(200, user.get("map").statusCode());

    String path = "api/v1/users/" + id + "/sessions/" + session;
    assertEquals(204, manager.sendJson("DELETE", path, "").statusCode());
    assertEquals(303, user.get("map").statusCode());
  }

  @Test
  void aTokenIsShownOnceAndWorksUntilItIsEnded() {
    String token = createToken("=cmd <b>");
    String page = user.get("users/" + id).body();
    assertFalse(page.contains(token));
    assertTrue(page.contains("=cmd &lt;b&gt;"), "as text");
    assertEquals(200, withToken("GET", "api/v1/tasks", token).statusCode());

    JsonNode sessions = JSON.readTree(user.get("api/v1/users/" + id + "/sessions").body());
    assertEquals("TOKEN", sessions.get(0).get("kind").stringValue());
    assertEquals("=cmd <b>", sessions.get(0).get("name").stringValue());
    assertEquals("[\"read\"]", sessions.get(0).get("scopes").toString());
    assertEquals(204, withToken("DELETE", "api/v1/session", token).statusCode());
    assertEquals(401, withToken("GET", "api/v1/tasks", token).statusCode());
    assertEquals(200, user.get("map").statusCode(), "the browser's session goes on");
  }

  @Test
  void theApiMakesATokenForItsOwnUserOnly() {
    String body = tokenOrder("\"name\":\"ci\",\"days\":1");
    HttpResponse<String> made = user.postJson("api/v1/users/" + id + "/tokens", body);

    assertEquals(201, made.statusCode());
    String token = JSON.readTree(made.body()).get("token").stringValue();
    assertEquals(200, withToken("GET", "api/v1/robots", token).statusCode());
    assertEquals(403, manager.postJson("api/v1/users/" + id + "/tokens", body).statusCode());
    for (String wrong :
        new String[] {
          "\"name\":\"\",\"days\":1",
          "\"name\":\"x\",\"days\":0",
          "\"name\":\"x\",\"days\":366",
          "\"name\":\"x\"",
          "\"name\":\"a\\u0000b\",\"days\":1"
        }) {
      assertEquals(
          422,
          user.postJson("api/v1/users/" + id + "/tokens", tokenOrder(wrong)).statusCode(),
          wrong);
    }
  }

  @Test
  void aTokenIsNoCookieAndACookieNoToken() {
    String token = createToken("ci");
    try (TestClient visitor = new TestClient(server.root())) {
      HttpResponse<String> answer =
          visitor.send(
              visitor.request("api/v1/tasks").header("Cookie", "toqa-session=" + token).build());
      assertEquals(401, answer.statusCode());
    }
  }

  @Test
  void whoForgotHisPasswordReplacesItByALetter() throws Exception {
    try (TestClient stranger = new TestClient(server.root())) {
      HttpResponse<String> asked =
          stranger.post("forgotten", Map.of("user", name.toUpperCase(Locale.ROOT)));
      assertEquals("/forgotten?done=sent", asked.headers().firstValue("Location").orElseThrow());
      TestMailbox.Message letter = Objects.requireNonNull(server.mailbox().next(20));
      assertEquals(name + "@example.org", letter.to());
      assertTrue(letter.text().contains("https://toqa.example.org/reset?secret="), letter.text());
      String secret = linkSecret(letter.text());

      HttpResponse<String> opened = stranger.get("reset?secret=" + secret);
      assertEquals("/reset", opened.headers().firstValue("Location").orElseThrow());
      String page = stranger.get("reset").body();
      assertTrue(page.contains(name));
      assertFalse(page.contains(secret), "nor does the link to another language have it");
      HttpResponse<String> weak = stranger.post("reset", Map.of("password", "password12"));
      assertEquals(422, weak.statusCode());
      HttpResponse<String> done = stranger.post("reset", Map.of("password", NEW_PASSWORD));

      assertEquals("/?done=reset", done.headers().firstValue("Location").orElseThrow());
      assertEquals(303, user.get("map").statusCode(), "old sessions have ended");
      stranger.get("reset?secret=" + secret);
      assertEquals(410, stranger.get("reset").statusCode());
      assertEquals(
          410, stranger.post("reset", Map.of("password", "a third one, then")).statusCode());
      assertEquals(
          303, stranger.post("", Map.of("name", name, "password", NEW_PASSWORD)).statusCode());
    }
  }

  @Test
  void nobodyLearnsWhetherThereIsSuchAUser() throws Exception {
    try (TestClient stranger = new TestClient(server.root())) {
      String there = stranger.post("forgotten", Map.of("user", name)).body();
      assertEquals(Objects.requireNonNull(server.mailbox().next(20)).to(), name + "@example.org");

      HttpResponse<String> answer = stranger.post("forgotten", Map.of("user", "nobody at all"));

      assertEquals(303, answer.statusCode());
      assertEquals(there, answer.body());
      assertEquals(
          202,
          stranger.postJson("api/v1/forgotten-password", "{\"user\":\"nobody\"}").statusCode());
      // the next letter is that of a user who is there: none was sent in between
      server.addUser(name + "b", name + "b@example.org", Role.CLERK);
      stranger.post("forgotten", Map.of("user", name + "b@EXAMPLE.org"));
      assertEquals(Objects.requireNonNull(server.mailbox().next(20)).to(), name + "b@example.org");
    }
  }

  @Test
  void requestsForResetLinksAreThrottled() {
    try (TestClient stranger = new TestClient(server.root())) {
      for (int i = 0; i < 5; i++) {
        assertEquals(303, stranger.post("forgotten", Map.of("user", "flooded")).statusCode());
      }
      HttpResponse<String> answer = stranger.post("forgotten", Map.of("user", "FLOODED"));

      assertEquals(422, answer.statusCode());
      assertTrue(answer.body().contains("Too many failed attempts"), answer.body());
      assertEquals(
          429,
          stranger.postJson("api/v1/forgotten-password", "{\"user\":\"flooded\"}").statusCode());
    }
  }

  @Test
  void aManagerMakesALinkWhichEndsTheOneBefore() {
    assertEquals(403, user.post("users/" + id + "/reset-link", Map.of()).statusCode());
    HttpResponse<String> made = manager.post("users/" + id + "/reset-link", Map.of());
    String first = linkSecret(secret(manager.get(location(made))));
    HttpResponse<String> byApi = manager.postJson("api/v1/users/" + id + "/reset-link", "");
    assertEquals(201, byApi.statusCode());
    String second = linkSecret(JSON.readTree(byApi.body()).get("link").stringValue());
    assertNotEquals(first, second);

    try (TestClient stranger = new TestClient(server.root())) {
      String body = "{\"secret\":\"%s\",\"password\":\"%s\"}";
      assertEquals(
          410,
          stranger
              .postJson("api/v1/reset-password", body.formatted(first, NEW_PASSWORD))
              .statusCode());
      assertEquals(
          422,
          stranger.postJson("api/v1/reset-password", body.formatted(second, "short")).statusCode());
      assertEquals(
          204,
          stranger
              .postJson("api/v1/reset-password", body.formatted(second, NEW_PASSWORD))
              .statusCode());
      assertEquals(
          303, stranger.post("", Map.of("name", name, "password", NEW_PASSWORD)).statusCode());
    }
  }

  @Test
  void anEmailAddressIsChangedWithThePassword() {
    Map<String, String> wrong =
        Map.of("email", "thief@example.org", "password", "guessed it maybe");
    assertTrue(user.post("users/" + id + "/email", wrong).body().contains("password is wrong"));
    assertEquals(name + "@example.org", email());

    Map<String, String> right =
        Map.of("email", "new@example.org", "password", WebTestServer.PASSWORD);
    assertEquals(303, user.post("users/" + id + "/email", right).statusCode());
    assertEquals("new@example.org", email());
    assertEquals(
        204, manager.postJson("api/v1/users/" + id + "/email", "{\"email\":null}").statusCode());
    assertEquals("", email());
    for (String bad :
        new String[] {"a b@example.org", "x@y\\r\\nBcc: all@example.org", "x", "a@b,c@d"}) {
      String body = "{\"email\":\"" + bad + "\"}";
      assertEquals(422, manager.postJson("api/v1/users/" + id + "/email", body).statusCode(), bad);
    }
  }

  @Test
  void guessingThePasswordBehindALoginIsSlowedToo() {
    Map<String, String> guess = Map.of("email", "thief@example.org", "password", "a guess");
    for (int i = 0; i < 5; i++) {
      assertTrue(user.post("users/" + id + "/email", guess).body().contains("password is wrong"));
    }
    assertTrue(
        user.post("users/" + id + "/email", guess).body().contains("Too many failed attempts"));
  }

  @Test
  void whoAsksForLettersAgainAndAgainVoidsNoLinkAndSendsNoSecondOne() throws Exception {
    try (TestClient stranger = new TestClient(server.root())) {
      stranger.post("forgotten", Map.of("user", name));
      TestMailbox.Message letter = Objects.requireNonNull(server.mailbox().next(20));
      for (int i = 0; i < 3; i++) {
        assertEquals(303, stranger.post("forgotten", Map.of("user", name)).statusCode());
      }
      // the next letter is another's
      server.addUser(name + "b", name + "b@example.org", Role.CLERK);
      stranger.post("forgotten", Map.of("user", name + "b"));
      assertEquals(Objects.requireNonNull(server.mailbox().next(20)).to(), name + "b@example.org");

      stranger.get("reset?secret=" + linkSecret(letter.text()));
      assertEquals(303, stranger.post("reset", Map.of("password", NEW_PASSWORD)).statusCode());
    }
  }

  @Test
  void whatAPageAsksByItselfIsNoUseOfTheSession() throws Exception {
    Instant seen = Instant.parse(session().get("seenAt").stringValue());
    server.letSessionsAge(Duration.ofMinutes(10));

    user.send(user.request("map").header("X-Toqa-Background", "yes").build());
    assertEquals(200, user.send("HEAD", "api/v1/events").statusCode());
    try (TestClient other = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      JsonNode unused = JSON.readTree(other.get("api/v1/users/" + id + "/sessions").body()).get(0);
      assertEquals(
          seen.minus(Duration.ofMinutes(10)), Instant.parse(unused.get("seenAt").stringValue()));
    }
    user.get("map");
    assertTrue(
        Instant.parse(session().get("seenAt").stringValue())
            .isAfter(seen.minus(Duration.ofMinutes(1))));
  }

  private JsonNode session() {
    return JSON.readTree(manager.get("api/v1/users/" + id + "/sessions").body()).get(0);
  }

  private static String tokenOrder(String fields) {
    return "{%s,\"scopes\":[\"read\"],\"password\":\"%s\"}"
        .formatted(fields, WebTestServer.PASSWORD);
  }

  private String createToken(String tokenName) {
    HttpResponse<String> made =
        user.post(
            "users/" + id + "/tokens",
            Map.of(
                "tokenName",
                tokenName,
                "days",
                "7",
                "scopes",
                "read",
                "password",
                WebTestServer.PASSWORD));
    return secret(user.get(location(made)));
  }

  private static String location(HttpResponse<String> answer) {
    return answer.headers().firstValue("Location").orElseThrow().substring(1);
  }

  private String email() {
    return Objects.requireNonNullElse(server.accounts().account(id).orElseThrow().email(), "");
  }

  private static String secret(HttpResponse<String> page) {
    Matcher matcher = SECRET.matcher(page.body());
    assertTrue(matcher.find(), page.body());
    return matcher.group(1);
  }

  private static String linkSecret(String text) {
    Matcher matcher = LINK.matcher(text);
    assertTrue(matcher.find(), text);
    return matcher.group(1);
  }

  private HttpResponse<String> withToken(String method, String path, String token) {
    try (TestClient program = new TestClient(server.root())) {
      return program.send(
          program
              .request(path)
              .header("Authorization", "Bearer " + token)
              .method(method, HttpRequest.BodyPublishers.noBody())
              .build());
    }
  }
}
