package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.notices.Condition;
import org.toqa.notices.Notice;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticeStore.Change;
import org.toqa.notices.WebhookSecret;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;
import tools.jackson.databind.JsonNode;

/** Notices, how somebody is told of them, and webhooks, by the API. */
class ApiNoticesTest extends ApiTestServer {
  private static final String ALL_OFF = "{\"channels\":{}}";

  private void begin(NoticeKind kind, String subject) {
    Instant now = Instant.now();
    Condition condition =
        new Condition(
            kind,
            subject,
            "hall",
            null,
            subject,
            null,
            Phrase.NOTICE_OF_ROBOT.with(subject, Phrase.NOTICE_ROBOT_LOST.with()));
    server
        .notices()
        .add(
            List.of(
                new Change(
                    new Notice(0, UUID.randomUUID(), condition, now, null), false, List.of())),
            now,
            _ -> false);
  }

  private JsonNode json(String path) {
    HttpResponse<String> answer = get(path);
    assertEquals(200, answer.statusCode(), answer::body);
    return JSON.readTree(answer.body());
  }

  @Test
  void noticesAreListedAndSeen() {
    begin(NoticeKind.ROBOT_LOST, "r1");
    begin(NoticeKind.ROBOT_LOST, "r2");
    begin(NoticeKind.SERVER, "r3");

    JsonNode first = json("api/v1/notices?limit=2");
    assertEquals(2, first.get("notices").size());
    JsonNode newest = first.get("notices").get(0);
    assertEquals("server", newest.get("kind").stringValue());
    assertEquals("r3: lost, nothing is heard of it", newest.get("text").stringValue());
    assertTrue(newest.get("endedAt").isNull());
    JsonNode older = json("api/v1/notices?before=" + first.get("next").asLong());
    assertEquals("r1", older.get("notices").get(0).get("robot").stringValue());
    assertEquals(3, json("api/v1/notices/news").get("unseen").asInt());

    long oldest = older.get("notices").get(0).get("id").asLong();
    assertEquals(204, post(token, "api/v1/notices/" + oldest + "/seen", "{}").statusCode());
    assertEquals(2, json("api/v1/notices/news").get("unseen").asInt());
    assertEquals(2, json("api/v1/notices?show=unseen").get("notices").size());
    assertEquals(
        WebTestServer.MANAGER,
        json("api/v1/notices?before=" + (oldest + 1)).at("/notices/0/seen/0/user").stringValue());

    assertEquals(
        204,
        post(token, "api/v1/notices/seen", "{\"upTo\":%d}".formatted(newest.get("id").asLong()))
            .statusCode());
    assertEquals(0, json("api/v1/notices/news").get("unseen").asInt());
    assertEquals(422, get("api/v1/notices?show=mine").statusCode());
    assertEquals(422, post(token, "api/v1/notices/seen", "{\"upTo\":0.5}").statusCode());
  }

  @Test
  void whatWasChosenIsToldAndNothingElse() {
    assertEquals(
        200,
        send(
                "PUT",
                "api/v1/notices/settings",
                """
                {"channels":{"robot-lost":["badge","browser","sound"],"server":["email"]},
                 "ownTasksOnly":true,"ends":true,"quietFrom":"22:00","quietUntil":"22:01",
                 "zone":"Europe/Berlin"}
                """)
            .statusCode());
    JsonNode settings = json("api/v1/notices/settings");
    assertEquals(
        "[\"badge\",\"browser\",\"sound\"]", settings.get("channels").get("robot-lost").toString());
    assertEquals("[]", settings.get("channels").get("standstill").toString());
    assertEquals("22:00", settings.get("quietFrom").stringValue());
    assertTrue(settings.get("ends").booleanValue());

    send("PUT", "api/v1/notices/settings", settings.toString().replace("\"22:0", "\"00:0"));
    begin(NoticeKind.ROBOT_LOST, "r1");
    begin(NoticeKind.SERVER, "r2");
    assertEquals(
        200,
        send(
                "PUT",
                "api/v1/notices/settings",
                "{\"channels\":{\"robot-lost\":[\"badge\",\"browser\"]}}")
            .statusCode());
    JsonNode news = json("api/v1/notices/news");
    assertEquals(1, news.get("unseen").asInt());
    assertEquals(1, news.get("told").size());
    assertEquals("Robot lost", news.at("/told/0/title").stringValue());
    assertTrue(news.at("/told/0/browser").booleanValue());
    assertFalse(news.at("/told/0/sound").booleanValue());

    send("PUT", "api/v1/notices/settings", ALL_OFF);
    assertEquals(0, json("api/v1/notices/news").get("unseen").asInt());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{}|channels",
        "{\"channels\":{\"robot-lost\":[\"pigeon\"]}}|channels.robot-lost",
        "{\"channels\":{\"robot-found\":[\"badge\"]}}|channels.robot-found",
        "{\"channels\":{},\"quietFrom\":\"22:00\"}|quietUntil",
        "{\"channels\":{},\"quietFrom\":\"22:00\",\"quietUntil\":\"22:00\"}|quietUntil",
        "{\"channels\":{},\"quietFrom\":\"25:00\",\"quietUntil\":\"22:00\"}|quietFrom",
        "{\"channels\":{},\"zone\":\"Mars\"}|zone",
        "{\"channels\":{},\"more\":1}|more"
      })
  void wrongSettingsGetASentenceAtTheirField(String body, String field) {
    HttpResponse<String> answer = send("PUT", "api/v1/notices/settings", body);

    assertEquals(422, answer.statusCode(), answer::body);
    assertEquals(
        field, JSON.readTree(answer.body()).at("/errors/0/field").stringValue(), answer::body);
  }

  @ParameterizedTest
  @CsvSource({
    "https://10.0.0.1/hook, private network",
    "https://[::1]/hook, private network",
    "https://169.254.169.254/latest, private network",
    "http://8.8.8.8/hook, Use https",
    "https://user:secret@8.8.8.8/, without a user",
    "https://8.8.8.8/#part, without a user",
    "ftp://8.8.8.8/, begins with https",
    "'https://8.8.8.8:99999/', begins with https",
    "nonsense, begins with https",
    "https://no-such-host.invalid/, No machine"
  })
  void aWebhookThatMustNotBeIsRefusedWithASentence(String url, String sentence) {
    HttpResponse<String> answer =
        post(token, "api/v1/webhooks", "{\"url\":\"%s\",\"kinds\":[\"server\"]}".formatted(url));

    assertEquals(422, answer.statusCode(), answer::body);
    assertTrue(
        JSON.readTree(answer.body()).at("/errors/0/detail").stringValue().contains(sentence),
        answer::body);
  }

  @Test
  void aWebhookIsTriedChangedAndDeletedAndItsSecretIsToldOnce() throws Exception {
    List<String> arrived = new CopyOnWriteArrayList<>();
    HttpServer receiver =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    receiver.createContext(
        "/",
        exchange -> {
          String body =
              new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8);
          arrived.add(
              exchange.getRequestHeaders().getFirst("webhook-id")
                  + "|"
                  + exchange.getRequestHeaders().getFirst("webhook-timestamp")
                  + "|"
                  + exchange.getRequestHeaders().getFirst("webhook-signature")
                  + "|"
                  + body);
          exchange.sendResponseHeaders(
              exchange.getRequestURI().getPath().equals("/") ? 200 : 404, -1);
          exchange.close();
        });
    receiver.start();
    try {
      String url = "http://127.0.0.1:" + receiver.getAddress().getPort() + "/";
      HttpResponse<String> added =
          post(
              token,
              "api/v1/webhooks",
              "{\"url\":\"%s\",\"kinds\":[\"server\",\"robot-lost\"]}".formatted(url));
      assertEquals(201, added.statusCode(), added::body);
      JsonNode webhook = JSON.readTree(added.body());
      WebhookSecret secret = new WebhookSecret(webhook.get("secret").stringValue());
      String path = "api/v1/webhooks/" + webhook.get("id").asLong();
      assertTrue(json("api/v1/webhooks").get(0).get("secret").isNull());

      assertEquals(204, post(token, path + "/test", "").statusCode());
      String[] parts = arrived.getFirst().split("\\|", 4);
      assertEquals(secret.signature(parts[0], Long.parseLong(parts[1]), parts[3]), parts[2]);
      assertTrue(parts[3].contains("\"notice.test\""), parts[3]);

      assertEquals(
          200,
          send(
                  "PUT",
                  path,
                  "{\"url\":\"%sx\",\"kinds\":[\"server\"],\"enabled\":false}".formatted(url))
              .statusCode());
      HttpResponse<String> failed = post(token, path + "/test", "");
      assertEquals(502, failed.statusCode());
      assertTrue(failed.body().contains("404"), failed::body);
      assertFalse(json("api/v1/webhooks").get(0).get("enabled").booleanValue());

      change(path, "http://127.0.0.1:1/");
      assertFailedTest(path, "Nothing answers at 127.0.0.1:1.");

      JsonNode renewed = JSON.readTree(post(token, path + "/secret", "").body());
      assertFalse(renewed.get("secret").stringValue().equals(secret.text()));
      assertEquals(204, send("DELETE", path, "").statusCode());
      assertEquals("[]", get("api/v1/webhooks").body());
      assertEquals(404, post(token, path + "/test", "").statusCode());
    } finally {
      receiver.stop(0);
    }
  }

  private void change(String path, String url) {
    String change = "{\"url\":\"%s\",\"kinds\":[\"server\"]}".formatted(url);
    assertEquals(200, send("PUT", path, change).statusCode());
  }

  private void assertFailedTest(String path, String sentence) {
    HttpResponse<String> failed = post(token, path + "/test", "");
    assertEquals(502, failed.statusCode(), failed::body);
    assertTrue(failed.body().contains(sentence), failed::body);
  }

  @Test
  void aSiteHasTwentyWebhooks() {
    String order = "{\"url\":\"https://8.8.8.8/\",\"kinds\":[\"server\"]}";
    for (int i = 0; i < 20; i++) {
      assertEquals(201, post(token, "api/v1/webhooks", order).statusCode());
    }
    assertEquals(409, post(token, "api/v1/webhooks", order).statusCode());
  }
}
