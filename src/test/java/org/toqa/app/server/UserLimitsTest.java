package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Setting;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.json.JsonMapper;

/** What one user or address may have of the running server, and what it says beyond that. */
@Timeout(120)
class UserLimitsTest {
  private static final JsonMapper JSON = JsonMapper.shared();

  /** Cells along each side of the large floor. */
  private static final int SIDE = 1000;

  /** Between walls of the large floor, in cells. */
  private static final int AISLE = 50;

  /** Bytes of a form. */
  private static final int BODY = 5000;

  private static final String BEGINNING = "name=a";

  private static final String TOKEN =
      "{\"name\":\"ci\",\"days\":1,\"scopes\":[\"read\"],\"password\":\"%s\"}"
          .formatted(WebTestServer.PASSWORD);
  private static final String TOO_MANY_TOKENS =
      "You have as many API tokens as one user may have. Remove one that is not needed any more.";

  @TempDir private Path folder;

  /** A search for room for two all over a million cells takes far longer than a check may. */
  @Test
  @Tag("full")
  void ofMorePreviewsThanAUserMayHaveAtOnceTheOthersWaitAndOneThatTakesTooLongIsEnded()
      throws Exception {
    try (AttackedServer server =
            start(Map.of(Setting.CHECKS_PER_USER, "1", Setting.MAP, largeFloor().toString()));
        TestClient manager = server.signedIn(AttackedServer.MANAGER);
        TestClient clerk = server.signedIn(AttackedServer.CLERK)) {
      for (String robot : List.of("r1", "r2")) {
        String order =
            "{\"name\":\"%s\",\"host\":\"127.0.0.1\",\"port\":1,\"maxLoad\":5}".formatted(robot);
        assertEquals(201, manager.postJson("api/v1/robots", order).statusCode());
      }
      String csrf = clerk.csrf();
      String preview =
          """
          {"name": "plate", "load": 9, "start": {"x": 1.225, "y": 1.225},
           "goal": {"x": 48.775, "y": 48.775}, "size": {"length": 0.6, "width": 0.4}}
          """;

      List<HttpResponse<String>> answers =
          atOnce(3, () -> clerk.sendJson("POST", "api/v1/tasks/preview", preview, csrf));

      assertEquals(List.of(429, 429, 503), answers.stream().map(HttpResponse::statusCode).toList());
      for (HttpResponse<String> refused : answers.subList(0, 2)) {
        assertEquals("1", retryAfter(refused));
        assertEquals(
            "As many of your orders and previews are being checked as one user may have at once."
                + " Nothing was accepted: send this one again in a second.",
            detail(refused));
      }
      assertEquals("5", retryAfter(answers.getLast()));
      assertEquals(
          "This took too long to check, and nothing was accepted."
              + " Try again in a few seconds, or order less at once.",
          detail(answers.getLast()));
    }
  }

  @Test
  void ofMoreRequestsThanAnAddressMayHaveAnsweredAtOnceTheOthersAreToldToWait() throws Exception {
    List<Socket> halves = new ArrayList<>();
    try (AttackedServer server = start(Map.of(Setting.PROXY, "", Setting.REQUESTS_AT_ONCE, "2"));
        TestClient visitor = server.signedIn(AttackedServer.CLERK)) {
      HttpResponse<String> refused = visitor.get("map");
      while (refused.statusCode() != 429) { // one that comes while this is answered is refused
        halves.add(half(server));
        refused = visitor.get("map");
      }

      assertTrue(halves.size() > 1, "two may be answered at once");
      assertEquals("1", retryAfter(refused));
      assertTrue(
          refused
              .body()
              .contains(
                  "2 requests from your address are being answered."
                      + " Wait for one of them, then try again."),
          refused::body);
      assertEquals(200, visitor.get("api/v1/health").statusCode(), "monitors are");
      closeAll(halves);
      awaitAnswer(visitor);
    } finally {
      closeAll(halves);
    }
  }

  private static void closeAll(List<Socket> sockets) throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
  }

  @Test
  void ofMoreTokensThanAUserMayHaveTheNextIsRefusedUntilOneIsRemoved() throws Exception {
    try (AttackedServer server = start(Map.of(Setting.SESSIONS_PER_USER, "3"));
        TestClient clerk = server.signedIn(AttackedServer.CLERK)) {
      String tokens = "api/v1/users/" + server.userId(AttackedServer.CLERK) + "/tokens";
      long session = 0;
      for (int i = 0; i < 3; i++) {
        HttpResponse<String> made = server.observed(clerk.postJson(tokens, TOKEN));
        assertEquals(201, made.statusCode());
        session = JSON.readTree(made.body()).at("/session/id").asLong();
      }

      HttpResponse<String> refused = clerk.postJson(tokens, TOKEN);
      assertEquals(422, refused.statusCode());
      assertTrue(refused.body().contains(TOO_MANY_TOKENS), refused::body);
      HttpResponse<String> byForm =
          clerk.post(
              "users/" + server.userId(AttackedServer.CLERK) + "/tokens",
              Map.of(
                  "tokenName", "ci",
                  "days", "1",
                  "scopes", "read",
                  "password", WebTestServer.PASSWORD));
      assertEquals(422, byForm.statusCode());
      assertTrue(byForm.body().contains(TOO_MANY_TOKENS), byForm::body);
      String one = tokens.replace("tokens", "sessions/" + session);
      assertEquals(204, clerk.sendJson("DELETE", one, "").statusCode());
      assertEquals(201, server.observed(clerk.postJson(tokens, TOKEN)).statusCode());
    }
  }

  private AttackedServer start(Map<Setting, String> limits) throws Exception {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.putAll(limits);
    settings.put(Setting.SIMULATE, "0");
    settings.put(Setting.SPEED, "1");
    return AttackedServer.start(folder.resolve("data"), settings);
  }

  private static List<HttpResponse<String>> atOnce(
      int count, Callable<HttpResponse<String>> request) throws Exception {
    try (ExecutorService threads = Executors.newVirtualThreadPerTaskExecutor()) {
      List<HttpResponse<String>> answers = new ArrayList<>();
      for (Future<HttpResponse<String>> answer :
          threads.invokeAll(Collections.nCopies(count, request))) {
        answers.add(answer.get());
      }
      answers.sort(Comparator.comparingInt(HttpResponse::statusCode));
      return answers;
    }
  }

  /** Asks until a page comes. */
  private static void awaitAnswer(TestClient visitor) throws InterruptedException {
    while (visitor.get("map").statusCode() != 200) {
      TimeUnit.MILLISECONDS.sleep(10);
    }
  }

  /** A login of which a part is missing. */
  private static Socket half(AttackedServer server) throws IOException {
    Socket socket = new Socket(server.root().getHost(), server.root().getPort());
    socket
        .getOutputStream()
        .write(
            ("POST / HTTP/1.1\r\nHost: localhost\r\n"
                    + "Content-Type: application/x-www-form-urlencoded\r\n"
                    + "Content-Length: "
                    + BODY
                    + "\r\n\r\n"
                    + BEGINNING)
                .getBytes(StandardCharsets.US_ASCII));
    return socket;
  }

  private static String retryAfter(HttpResponse<String> answer) {
    return answer.headers().firstValue("Retry-After").orElse("");
  }

  private static String detail(HttpResponse<String> answer) {
    return JSON.readTree(answer.body()).get("detail").asString();
  }

  /** 50 m by 50 m with walls from north and south by turns, so that the way leads round each. */
  private Path largeFloor() throws IOException {
    ByteArrayOutputStream picture = new ByteArrayOutputStream();
    picture.writeBytes("P5 %d %d 255\n".formatted(SIDE, SIDE).getBytes(StandardCharsets.US_ASCII));
    for (int row = 0; row < SIDE; row++) {
      for (int column = 0; column < SIDE; column++) {
        boolean isOpen = column % (2 * AISLE) == 0 ? row < AISLE : row >= SIDE - AISLE;
        picture.write(column % AISLE == 0 && !isOpen ? 0 : 255);
      }
    }
    Files.write(folder.resolve("large.pgm"), picture.toByteArray());
    return Files.writeString(
        folder.resolve("large.yaml"),
        """
        image: large.pgm
        resolution: 0.05
        origin: [0.0, 0.0, 0.0]
        negate: 0
        occupied_thresh: 0.65
        free_thresh: 0.196
        """);
  }
}
