package org.toqa.web.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Live events: coming back to them, not reading them, and losing the right to see them. */
@Tag("full")
@Timeout(60)
class EventsTest {
  private WebTestServer server;
  private TestClient clerk;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.start();
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
  }

  @AfterEach
  void stop() throws Exception {
    clerk.close();
    server.close();
  }

  @Test
  void whoComesBackGetsNothingTwice() throws IOException {
    String seen;
    try (BufferedReader lines = open(clerk, "")) {
      seen = value("id: ", lines);
    }

    try (BufferedReader lines = open(clerk, seen)) {
      assertEquals("alive", value("event: ", lines));
      driveTo(2);
      assertEquals("snapshot", event(lines));
      assertNotEquals(seen, value("id: ", lines));
    }
  }

  @Test
  void whoMissedSomethingGetsTheNewestAtOnce() throws IOException {
    String seen;
    try (BufferedReader lines = open(clerk, "")) {
      seen = value("id: ", lines);
    }
    driveTo(2);
    driveTo(3);

    try (BufferedReader lines = open(clerk, seen)) {
      assertEquals("snapshot", event(lines));
      assertTrue(value("data: ", lines).contains("\"x\":3"));
    }
  }

  @Test
  void whoAsksForChangesGetsAllOnceAndThenWhatChanged() throws IOException {
    driveTo(1);
    try (BufferedReader lines = open(clerk, "?changes=true", "")) {
      assertEquals("snapshot", event(lines));
      JsonNode first = JsonMapper.shared().readTree(value("data: ", lines));
      assertTrue(first.get("robots").get(0).has("maxLoad"), first.toString());
      driveTo(2);
      assertEquals("change", event(lines));
      String id = value("id: ", lines);
      JsonNode change = JsonMapper.shared().readTree(value("data: ", lines));
      assertEquals("r1", change.get("robots").get(0).get("name").asString());
      assertEquals(2, change.get("robots").get(0).get("pose").get("x").asDouble());
      assertFalse(change.get("robots").get(0).has("maxLoad"), change.toString());
      assertFalse(change.has("tasks"), change.toString());

      try (BufferedReader again = open(clerk, "?changes=true", id)) {
        assertEquals("alive", value("event: ", again));
        driveTo(3);
        assertEquals("change", event(again));
      }
      try (BufferedReader late = open(clerk, "?changes=true", id)) {
        assertEquals("snapshot", event(late), "it missed something");
      }
    }
  }

  @Test
  void aUserHasSoManyStreamsAtOnceAndThenHisNextWhenOneHasEnded() throws IOException {
    List<BufferedReader> streams = new ArrayList<>();
    for (int i = 0; i < WebTestServer.STREAMS_PER_USER; i++) {
      streams.add(open(clerk, ""));
    }

    HttpResponse<String> refused = clerk.get("api/v1/events");

    assertEquals(429, refused.statusCode());
    assertEquals("10", refused.headers().firstValue("Retry-After").orElse(""));
    assertTrue(refused.body().contains("You have 20 live views open"), refused.body());
    HttpResponse<String> inArabic =
        clerk.send(clerk.request("api/v1/events").header("Accept-Language", "ar").build());
    assertTrue(inArabic.body().contains("لديك 20"), inArabic.body());
    assertEquals(200, clerk.send("HEAD", "api/v1/events").statusCode());
    streams.getFirst().close();
    driveTo(1); // the server finds that nobody reads
    awaitStreams(WebTestServer.STREAMS_PER_USER - 1);
    open(clerk, "").close();
    for (BufferedReader stream : streams) {
      stream.close();
    }
  }

  @Test
  void anAddressHasSoManyStreamsWhoeverReadsThem() throws IOException {
    List<BufferedReader> streams = new ArrayList<>();
    try (TestClient manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      for (int i = 0; i < WebTestServer.STREAMS_PER_ADDRESS; i++) {
        streams.add(open(i < WebTestServer.STREAMS_PER_USER ? clerk : manager, ""));
      }

      HttpResponse<String> refused = manager.get("api/v1/events");

      assertEquals(429, refused.statusCode());
      assertTrue(refused.body().contains("From your address 30 live views"), refused.body());
      assertEquals(200, manager.get("map").statusCode());
    }
    for (BufferedReader stream : streams) {
      stream.close();
    }
  }

  @Test
  void askingForChangesIsAYesOrANo() {
    for (String query : List.of("?changes=1", "?changes=", "?changes=TRUE", "?changes=%00")) {
      HttpResponse<String> answer = clerk.get("api/v1/events" + query);
      assertEquals(400, answer.statusCode(), query);
      assertTrue(answer.body().contains("“changes” must be true or false."), answer.body());
    }
  }

  @Test
  void anIdThatIsNoneCountsAsNothing() throws IOException {
    for (String id : List.of("1", "-1", "9".repeat(5000), "x-1", "-", "null", "%00", "\"}{")) {
      try (BufferedReader lines = open(clerk, id)) {
        assertEquals("snapshot", event(lines), id);
      }
    }
  }

  @Test
  void anIdOfTheServersLifeBeforeIsNotTakenForOneOfThisLife() throws Exception {
    String before;
    try (BufferedReader lines = open(clerk, "")) {
      before = value("id: ", lines);
    }

    try (WebTestServer restarted = WebTestServer.start();
        TestClient again = TestClient.signedIn(restarted.root(), WebTestServer.CLERK);
        BufferedReader lines = open(again, before)) {
      assertEquals(server.fleet().latest().version(), restarted.fleet().latest().version());
      assertEquals("snapshot", event(lines));
    }
  }

  @Test
  void aQuietStreamSaysThatItIsAlive() throws IOException {
    try (BufferedReader lines = open(clerk, "")) {
      assertEquals("snapshot", event(lines));
      assertEquals("alive", value("event: ", lines));
    }
  }

  @Test
  void whoReadsNothingIsLeftAndNobodyWaitsForHim() throws Exception {
    byte[] request = request().getBytes(StandardCharsets.US_ASCII);
    server.setConnectionTimeout(Duration.ofSeconds(2));
    try (Socket stuck = new Socket()) {
      stuck.setReceiveBufferSize(4096);
      stuck.connect(new InetSocketAddress(server.root().getHost(), server.root().getPort()));
      stuck.getOutputStream().write(request);
      awaitStreams(1);
      server.setConnectionTimeout(Duration.ofSeconds(20));

      try (BufferedReader lines = open(clerk, "")) {
        server.fleet().setAlert("x".repeat(8_000_000)); // more than all buffers on the way hold
        assertTrue(data(lines).length() < 1000);
        assertTrue(data(lines).length() > 8_000_000);
        driveTo(2);
        assertTrue(data(lines).contains("\"x\":2"));
        awaitStreams(1);
        driveTo(3);
        assertTrue(data(lines).contains("\"x\":3"), "the other one goes on");
      }
    }
  }

  @Test
  void aStreamEndsWithTheSession() throws IOException {
    try (TestClient other = TestClient.signedIn(server.root(), WebTestServer.CLERK);
        BufferedReader lines = open(other, "")) {
      assertEquals("snapshot", event(lines));
      other.post("logout", Map.of());

      assertEnds(lines);
    }
  }

  @Test
  void aStreamEndsWhenItsUserIsDisabled() throws IOException {
    try (BufferedReader lines = open(clerk, "")) {
      assertEquals("snapshot", event(lines));
      Account clara = server.accounts().accountByName(WebTestServer.CLERK).orElseThrow();
      server.accounts().update(clara.id(), Role.CLERK, true, WebTestServer.MANAGER);

      assertEnds(lines);
    }
  }

  /** While the fleet is busy, so that it is no silence that ends it. */
  private void assertEnds(BufferedReader lines) throws IOException {
    for (int x = 1; lines.readLine() != null; x++) {
      driveTo(x);
    }
  }

  private void driveTo(double x) {
    server
        .fleet()
        .changeRobots(
            robots ->
                List.of(
                    Hall.robot("r1", RobotState.DRIVING, new Pose(x, 2, 0), "127.0.0.1", 7275)));
  }

  private String request() {
    String cookie =
        clerk
            .post("", Map.of("name", WebTestServer.CLERK, "password", WebTestServer.PASSWORD))
            .headers()
            .firstValue("Set-Cookie")
            .orElseThrow()
            .split(";", 2)[0];
    return "GET /api/v1/events HTTP/1.1\r\nHost: localhost\r\nCookie: %s\r\n\r\n".formatted(cookie);
  }

  private void awaitStreams(double count) {
    Instant limit = Instant.now().plusSeconds(30);
    while (streams() != count) {
      assertTrue(Instant.now().isBefore(limit), "not " + count);
    }
  }

  private double streams() {
    return clerk
        .get("api/v1/metrics")
        .body()
        .lines()
        .filter(line -> line.startsWith("toqa_streams "))
        .mapToDouble(line -> Double.parseDouble(line.substring("toqa_streams ".length())))
        .sum();
  }

  private static BufferedReader open(TestClient visitor, String lastId) {
    return open(visitor, "", lastId);
  }

  private static BufferedReader open(TestClient visitor, String query, String lastId) {
    HttpRequest request =
        visitor.request("api/v1/events" + query).header("Last-Event-ID", lastId).GET().build();
    InputStream stream = visitor.send(request, BodyHandlers.ofInputStream()).body();
    return new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8));
  }

  /** The next event, however quiet it was before. */
  private static String event(BufferedReader lines) throws IOException {
    String name = value("event: ", lines);
    while (name.equals("alive")) {
      name = value("event: ", lines);
    }
    return name;
  }

  /** What the next event tells. */
  private static String data(BufferedReader lines) throws IOException {
    event(lines);
    return value("data: ", lines);
  }

  private static String value(String field, BufferedReader lines) throws IOException {
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      if (line.startsWith(field)) {
        return line.substring(field.length());
      }
    }
    throw new AssertionError("The stream ended before any " + field);
  }
}
