package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.slf4j.LoggerFactory;
import org.toqa.accounts.Role;
import org.toqa.testbed.LogLevel;
import org.toqa.web.RequestLimit;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Who asks more often than the server is set to answer him. */
class RateLimitTest {
  private static final int PER_SECOND = 10;
  private static final int AT_ONCE = 20;

  private final AtomicLong nanos = new AtomicLong();
  private final ListAppender<ILoggingEvent> lines = new ListAppender<>();
  private final Logger log = (Logger) LoggerFactory.getLogger(RequestLimit.class);
  private final LogLevel level = LogLevel.usual(RequestLimit.class.getName());

  private WebTestServer server;
  private TestClient stranger;
  private TestClient clerk;
  private TestClient manager;
  private TestClient administrator;

  @BeforeEach
  void start() throws Exception {
    lines.start();
    log.addAppender(lines);
    server = WebTestServer.start(new RequestLimit(PER_SECOND, nanos::get));
    stranger = new TestClient(server.root());
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
    manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
    server.addUser("Ada", null, Role.ADMINISTRATOR);
    administrator = TestClient.signedIn(server.root(), "Ada");
    clerk.get("api/v1/robots");
    manager.get("api/v1/robots");
    administrator.get("api/v1/robots");
    pass(Duration.ofSeconds(5));
  }

  @AfterEach
  void stop() throws Exception {
    log.detachAppender(lines);
    level.close();
    stranger.close();
    clerk.close();
    administrator.close();
    manager.close();
    server.close();
  }

  @Test
  void whoAsksTheApiTooFastIsToldHowLongToWait() {
    for (int i = 0; i < AT_ONCE; i++) {
      assertEquals(200, clerk.get("api/v1/robots").statusCode());
    }

    HttpResponse<String> refused = clerk.get("api/v1/robots");

    assertEquals(429, refused.statusCode());
    assertEquals("1", refused.headers().firstValue("Retry-After").orElse(""));
    assertEquals(
        "application/problem+json", refused.headers().firstValue("Content-Type").orElse(""));
    JsonNode problem = JsonMapper.shared().readTree(refused.body());
    assertEquals("Too Many Requests", problem.get("title").asString());
    assertEquals("Too many requests. Wait 1 s, then slow down.", problem.get("detail").asString());
    HttpResponse<String> inArabic =
        clerk.send(clerk.request("api/v1/robots").header("Accept-Language", "ar").build());
    assertTrue(inArabic.body().contains("انتظر 1 ث"), inArabic::body);
  }

  @Test
  void whoAsksForPagesTooFastReadsItOnOne() {
    exhaust(clerk);

    HttpResponse<String> refused = clerk.get("tasks");

    assertEquals(429, refused.statusCode());
    assertEquals("1", refused.headers().firstValue("Retry-After").orElse(""));
    assertTrue(refused.body().contains("<h1>Too many requests</h1>"), refused::body);
    assertTrue(refused.body().contains("Wait 1 s"), refused::body);
    assertEquals(200, clerk.get("assets/css/base.css").statusCode());
  }

  @Test
  void inventedSecretsCostNoQueryOnceTheirAddressIsToldToWait() {
    exhaust(stranger);
    long before = server.sessionQueries();

    for (int i = 0; i < AT_ONCE; i++) {
      String secret = "%043d".formatted(i);
      assertEquals(429, withHeader("Cookie", "toqa-session=" + secret).statusCode());
      assertEquals(429, withHeader("Authorization", "Bearer " + secret).statusCode());
    }

    assertEquals(before, server.sessionQueries());
    assertEquals(200, manager.get("map").statusCode(), "who is known goes on");
  }

  @Test
  void anInventedSecretCountsOnce() {
    for (int i = 0; i < AT_ONCE; i++) {
      assertEquals(401, withHeader("Authorization", "Bearer %043d".formatted(i)).statusCode());
    }

    assertEquals(429, withHeader("Authorization", "Bearer another").statusCode());
  }

  @Test
  void allAddressesOfOneSubscriberCountAsOne() {
    for (int i = 0; i < AT_ONCE; i++) {
      assertEquals(401, statusFrom("2001:db8:0:7::" + Integer.toHexString(i + 1)));
    }

    assertEquals(429, statusFrom("2001:db8:0:7:ffff::1"));
    assertEquals(401, statusFrom("2001:db8:0:8::1"));
  }

  private int statusFrom(String address) {
    try (TestClient inventor = new TestClient(server.root(), address)) {
      return inventor
          .send(
              inventor.request("api/v1/robots").header("Authorization", "Bearer invented").build())
          .statusCode();
    }
  }

  @Test
  void theHealthOfTheServerCostsNoQuery() {
    long before = server.sessionQueries();

    stranger.send(
        stranger.request("api/v1/health").header("Authorization", "Bearer invented").build());

    assertEquals(before, server.sessionQueries());
  }

  private HttpResponse<String> withHeader(String name, String value) {
    try (TestClient inventor = new TestClient(server.root())) {
      return inventor.send(inventor.request("api/v1/robots").header(name, value).build());
    }
  }

  @Test
  void itOpensAgainAsTimePasses() {
    exhaust(clerk);

    pass(Duration.ofSeconds(1));

    for (int i = 0; i < PER_SECOND; i++) {
      assertEquals(200, clerk.get("api/v1/robots").statusCode());
    }
    assertEquals(429, clerk.get("api/v1/robots").statusCode());
  }

  @Test
  void othersAreNotTouched() {
    exhaust(clerk);
    assertEquals(200, manager.get("map").statusCode());
    assertEquals(200, stranger.get("").statusCode());

    exhaust(stranger);
    assertEquals(429, stranger.get("").statusCode());
    assertEquals(200, manager.get("map").statusCode());
  }

  @Test
  void aUserIsTheSameInEveryBrowser() {
    try (TestClient elsewhere = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      exhaust(clerk);

      assertEquals(429, elsewhere.get("map").statusCode());
    }
  }

  @Test
  void monitorsAreAnsweredAtAnyRate() {
    exhaust(stranger);
    exhaust(clerk);

    for (int i = 0; i < 2 * AT_ONCE; i++) {
      assertEquals(200, stranger.get("api/v1/health").statusCode());
      assertEquals(200, clerk.get("api/v1/health").statusCode());
    }
  }

  @Test
  void nothingThatIsRefusedIsDone() {
    String csrf = clerk.csrf();
    exhaust(clerk);

    assertEquals(
        429,
        clerk
            .sendJson(
                "POST",
                "api/v1/tasks",
                """
                {"name": "box", "load": 1, "start": {"station": "Dock A"},
                 "goal": {"station": "Dock B"}}
                """,
                csrf)
            .statusCode());

    assertEquals(List.of(), server.fleet().latest().tasks());
  }

  @Test
  void robotsAreStoppedHoweverFastTheSameUserAsksForOtherThings() {
    String csrf = clerk.csrf();
    String managersCsrf = manager.csrf();
    exhaust(clerk);
    exhaust(manager);

    assertEquals(303, clerk.postWithoutToken("fleet/pause", Map.of("_csrf", csrf)).statusCode());
    assertNotNull(server.fleet().latest().pause());
    assertEquals(
        200, manager.sendJson("POST", "api/v1/fleet/pause", "{}", managersCsrf).statusCode());
    for (int i = 1; i < AT_ONCE; i++) {
      clerk.postWithoutToken("fleet/pause", Map.of("_csrf", csrf));
    }
    assertEquals(
        429,
        clerk.postWithoutToken("fleet/pause", Map.of("_csrf", csrf)).statusCode(),
        "that has a limit of its own");
  }

  @Test
  void refusalsAreCountedAndToldOnceAMinuteWithoutSecrets() {
    exhaust(clerk);
    exhaust(stranger);

    assertEquals(1, lines.list.size());
    String line = lines.list.getFirst().getFormattedMessage();
    assertEquals("The user Clara asks more than 10 times a second, and is told to wait.", line);
    assertEquals(2, counted());

    pass(Duration.ofMinutes(1));
    exhaust(stranger);
    assertEquals(
        List.of(
            line, "The address 127.0.0.1 asks more than 10 times a second, and is told to wait."),
        lines.list.stream().map(ILoggingEvent::getFormattedMessage).toList());
  }

  private double counted() {
    String counter = "toqa_http_too_fast_total ";
    String line =
        administrator
            .get("api/v1/metrics")
            .body()
            .lines()
            .filter(l -> l.startsWith(counter))
            .findFirst()
            .orElseThrow();
    return Double.parseDouble(line.substring(counter.length()));
  }

  /** Asks until it is told to wait. */
  private static void exhaust(TestClient visitor) {
    int answered = 0;
    while (visitor.get("robots").statusCode() != 429) {
      answered++;
      assertFalse(answered > AT_ONCE, "nobody is told to wait");
    }
  }

  private void pass(Duration time) {
    nanos.addAndGet(time.toNanos());
  }
}
