package org.toqa.web.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Schedules through the form and the API. */
class SchedulesTest extends WebServerTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final String TASK =
      "{\"name\":\"box\",\"load\":1,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"x\":9,\"y\":1.05}}";
  private static final Map<String, String> FORM =
      Map.of(
          "name", "box",
          "load", "1",
          "startStation", "Dock A",
          "goalStation", "Shelf 3",
          "zone", "Europe/Paris");

  @AfterEach
  void deleteAll() {
    for (JsonNode schedule : JSON.readTree(manager.get("api/v1/schedules").body())) {
      manager.sendJson("DELETE", "api/v1/schedules/" + schedule.get("id"), "");
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"at\":\"2098-07-01T15:00:00Z\"",
        "\"from\":\"2098-07-01T15:00:00Z\",\"everyMinutes\":30,\"until\":\"2099-01-01T00:00:00Z\"",
        "\"weekdays\":[\"MONDAY\",\"FRIDAY\"],\"time\":\"08:00\",\"zone\":\"Europe/Paris\""
      })
  void whatIsAskedForComesBack(String times) {
    HttpResponse<String> answer = add(clerk, times);

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode schedule = JSON.readTree(answer.body());
    JSON.readTree("{" + times + "}")
        .properties()
        .forEach(e -> assertEquals(e.getValue(), schedule.get(e.getKey()), e.getKey()));
    assertEquals("box", schedule.get("task").get("name").stringValue());
    assertEquals("Clara", schedule.get("user").stringValue());
    assertFalse(schedule.get("due").isNull());
    String path = answer.headers().firstValue("Location").orElseThrow().substring(1);
    assertEquals(schedule, JSON.readTree(manager.get(path).body()));
    assertEquals(schedule, JSON.readTree(manager.get("api/v1/schedules").body()).get(0));
    assertEquals(0, server.fleet().count());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          "at":"soon"                                                  | at
          "at":"2001-01-01T00:00:00Z"                                  | at
          "x":1                                                        | at
          "everyMinutes":0,"from":"2098-07-01T15:00:00Z"               | everyMinutes
          "everyMinutes":1.5,"from":"2098-07-01T15:00:00Z"             | everyMinutes
          "everyMinutes":1e99,"from":"2098-07-01T15:00:00Z"            | everyMinutes
          "everyMinutes":5                                             | from
          "weekdays":[],"time":"08:00","zone":"UTC"                    | weekdays
          "weekdays":["MONDAY","MONDAY"],"time":"08:00","zone":"UTC"   | weekdays
          "weekdays":["Someday"],"time":"08:00","zone":"UTC"           | weekdays
          "weekdays":"MONDAY","time":"08:00","zone":"UTC"              | weekdays
          "weekdays":["MONDAY"],"time":"25:00","zone":"UTC"            | time
          "weekdays":["MONDAY"],"time":"08:00","zone":"Nowhere/Land"   | zone
          "weekdays":["MONDAY"],"time":"08:00"                         | zone
          "at":"2098-07-01T15:00:00Z","until":"2097-07-01T15:00:00Z"   | until
          """)
  void aWrongTimeIsToldAtItsField(String times, String field) {
    HttpResponse<String> answer = add(clerk, times);

    assertEquals(422, answer.statusCode(), answer.body());
    assertTrue(answer.body().contains("\"field\":\"" + field + "\""), answer.body());
    assertEquals("[]", clerk.get("api/v1/schedules").body());
  }

  @Test
  void aDriveWithoutALoadComesAgainAndAgain() {
    Map<String, String> form =
        Map.of(
            "name", "look",
            "kind", "drive",
            "goalStation", "Shelf 3",
            "goalWait", "60",
            "zone", "Europe/Paris",
            "when", "every",
            "first", "2098-07-01T15:00",
            "everyMinutes", "30");
    assertEquals(303, clerk.post("tasks/new", form).statusCode());

    JsonNode task = JSON.readTree(clerk.get("api/v1/schedules").body()).get(0).get("task");
    assertEquals("DRIVE", task.get("kind").stringValue());
    assertEquals("Shelf 3", task.get("stops").get(0).get("station").stringValue());
    assertEquals(60, task.get("stops").get(0).get("waitSeconds").asInt());
  }

  @Test
  void theTaskIsCheckedLikeAnyOther() {
    String at = ",\"at\":\"2098-07-01T15:00:00Z\"}";
    for (String wrong :
        List.of(
            "{\"task\":" + TASK.replace("Dock A", "Nowhere") + at,
            "{\"task\":" + TASK.replace("\"load\":1", "\"load\":-1") + at,
            "{\"task\":" + TASK.replace("}}", "},\"deadline\":\"2098-07-01T15:00:00Z\"}") + at,
            "{\"task\":7" + at,
            "{\"at\":\"2098-07-01T15:00:00Z\"}")) {
      HttpResponse<String> answer = clerk.postJson("api/v1/schedules", wrong);
      assertEquals(422, answer.statusCode(), wrong);
    }
    assertTrue(
        clerk
            .postJson(
                "api/v1/schedules", "{\"task\":" + TASK.replace("\"load\":1", "\"load\":-1") + at)
            .body()
            .contains("\"field\":\"task.load\""));
  }

  @Test
  void aClerkChangesHisOwnAndAManagerAll() {
    String at = "\"at\":\"2098-07-01T15:00:00Z\"";
    long other = id(add(manager, at));
    long own = id(add(clerk, at));
    String others = "api/v1/schedules/" + other;
    String path = "api/v1/schedules/" + own;

    assertEquals(403, clerk.postJson(others + "/pause", "").statusCode());
    assertEquals(403, clerk.post("schedules/" + other + "/delete", Map.of()).statusCode());
    assertEquals(403, clerk.sendJson("DELETE", others, "").statusCode());
    HttpResponse<String> paused = clerk.postJson(path + "/pause", "");
    assertTrue(paused.body().contains("\"paused\":true"), paused.body());
    HttpResponse<String> resumed = manager.postJson(path + "/resume", "");
    assertTrue(resumed.body().contains("\"paused\":false"), resumed.body());
    assertEquals(303, manager.post("schedules/" + own + "/pause", Map.of()).statusCode());
    String page = clerk.get("schedules").body();
    assertTrue(page.contains("/schedules/" + own + "/resume"), page);
    assertFalse(page.contains("/schedules/" + other + "/"), page);
    assertEquals(204, clerk.sendJson("DELETE", path, "").statusCode());
    assertEquals(404, clerk.get(path).statusCode());
    assertEquals(404, clerk.post("schedules/" + own + "/delete", Map.of()).statusCode());
    String history = clerk.get("history?kind=schedule").body();
    for (String told :
        List.of(
            "Clara added schedule %d: box",
            "Max paused schedule %d", "Clara deleted schedule %d")) {
      assertTrue(history.contains(told.formatted(own)), told);
    }
  }

  @Test
  void theFormAddsASchedule() {
    Map<String, String> form = new TreeMap<>(FORM);
    form.putAll(
        Map.of("when", "weekly", "weekday", "MONDAY", "time", "08:00", "idempotencyKey", "w"));

    HttpResponse<String> answer = clerk.post("tasks/new", form);

    assertEquals(303, answer.statusCode(), answer.body());
    String list = answer.headers().firstValue("Location").orElseThrow();
    assertTrue(list.startsWith("/schedules?added="), list);
    String page = clerk.get(list).body();
    assertTrue(page.contains("The schedule was added."), page);
    assertTrue(page.contains("Monday"), page);
    assertTrue(page.contains("Europe/Paris"), page);
    clerk.post("tasks/new", form);
    assertEquals(1, JSON.readTree(clerk.get("api/v1/schedules").body()).size(), "a double click");
    assertEquals(0, server.fleet().count());
    form.put("time", "09:00");
    assertEquals(303, clerk.post("tasks/new", form).statusCode(), "back in the browser, and again");
    assertEquals(2, JSON.readTree(clerk.get("api/v1/schedules").body()).size());
  }

  @Test
  void theSameIdempotencyKeyMakesOneSchedule() {
    String weekly =
        "\"weekdays\":[\"MONDAY\",\"FRIDAY\"],\"time\":\"08:00\",\"zone\":\"Europe/Paris\"";
    String once = "\"at\":\"2098-07-01T15:00:00.1234567Z\"";
    for (String times : List.of(weekly, once)) {
      String key = "key-" + times.length();
      long first = id(add(clerk, times, key));
      assertEquals(first, id(add(clerk, times, key)));

      HttpResponse<String> other = add(clerk, times + ",\"until\":\"2099-01-01T00:00:00Z\"", key);
      assertEquals(422, other.statusCode(), other.body());
      assertTrue(other.body().contains("was already used for another order"), other.body());
      assertNotEquals(first, id(add(manager, times, key)), "another user's key");
    }
    assertEquals(4, JSON.readTree(clerk.get("api/v1/schedules").body()).size());
  }

  @ParameterizedTest
  @CsvSource({
    "once, first, '', Enter a date and a time in the future",
    "once, first, 2001-01-01T10:00, This time has passed.",
    "every, everyMinutes, often, Enter a number, such as 2.5",
    "every, everyMinutes, '', Enter a whole number of minutes",
    "weekly, time, late, Enter a time of day",
    "weekly, weekday, SOMEDAY, Choose at least one day",
    "weekly, zone, Nowhere/Land, Unknown time zone.",
    "weekly, deadline, 2098-07-01T15:00, A scheduled task has no deadline.",
    "someday, first, '', Enter a date and a time in the future"
  })
  void aWrongFieldIsShownAgainWithASentence(
      String when, String field, String value, String sentence) {
    Map<String, String> form = new TreeMap<>(FORM);
    form.putAll(Map.of("first", "2098-07-01T15:00", "everyMinutes", "30", "weekday", "MONDAY"));
    form.putAll(Map.of("time", "08:00", "when", when));
    form.put(field, value);

    HttpResponse<String> answer = clerk.post("tasks/new", form);

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains(sentence), answer.body());
    assertEquals("[]", clerk.get("api/v1/schedules").body());
  }

  @Test
  void scriptInANameStaysText() {
    clerk.postJson(
        "api/v1/schedules",
        "{\"task\":%s,\"at\":\"2098-07-01T15:00:00Z\"}"
            .formatted(TASK.replace("box", "<script>alert(1)</script>")));

    String page = clerk.get("schedules").body();
    assertFalse(page.contains("<script>alert"), page);
    assertTrue(page.contains("&lt;script&gt;alert"), page);
  }

  private static long id(HttpResponse<String> answer) {
    return JSON.readTree(answer.body()).get("id").asLong();
  }

  private static HttpResponse<String> add(TestClient visitor, String times) {
    return visitor.postJson("api/v1/schedules", "{\"task\":%s,%s}".formatted(TASK, times));
  }

  private static HttpResponse<String> add(TestClient visitor, String times, String key) {
    return visitor.send(
        visitor
            .request("api/v1/schedules")
            .header("Content-Type", "application/json")
            .header("X-CSRF-Token", visitor.csrf())
            .header("Idempotency-Key", key)
            .POST(BodyPublishers.ofString("{\"task\":%s,%s}".formatted(TASK, times)))
            .build());
  }
}
