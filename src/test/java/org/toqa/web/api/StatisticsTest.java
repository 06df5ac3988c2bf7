package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.WorkHistory;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The statistics on their page, in the API and as files. */
class StatisticsTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final String WEEK = "from=2026-11-16&to=2026-11-22&zone=Europe/Paris";

  private static WebTestServer server;
  private static TestClient clerk;

  @BeforeAll
  static void start() throws Exception {
    server = WebTestServer.start();
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
    WorkHistory.in(server).addHour(Instant.parse("2026-11-20T12:00:00Z"));
  }

  @AfterAll
  static void stop() throws Exception {
    clerk.close();
    server.close();
  }

  @Test
  void theApiHasTotalsSeriesAndRobots() {
    JsonNode week = JSON.readTree(clerk.get("api/v1/statistics?" + WEEK).body());

    assertEquals("2026-11-15T23:00:00Z", week.get("from").stringValue());
    assertEquals("2026-11-22T23:00:00Z", week.get("until").stringValue());
    assertEquals("DAY", week.get("step").stringValue());
    JsonNode total = week.get("total");
    assertEquals(4, total.get("ordered").asInt());
    assertEquals(2, total.get("done").asInt());
    assertEquals(1, total.get("cancelled").asInt());
    assertEquals(20, total.at("/waiting/mean").asDouble()); // (10 + 30) / 2
    assertEquals(10, total.at("/waiting/median").asDouble());
    assertEquals(160, total.at("/delivery/p90").asDouble());
    assertEquals(150, total.get("metres").asDouble()); // 120 + 30
    assertEquals(1, total.at("/failures/task.robot-failed").asInt());
    assertEquals(7, week.get("series").size());
    JsonNode friday = week.get("series").get(4);
    assertEquals("2026-11-19T23:00:00Z", friday.get("from").stringValue());
    assertEquals(4, friday.get("ordered").asInt());
    assertEquals(0, week.get("series").get(3).get("ordered").asInt());
    assertTrue(week.get("series").get(3).get("waiting").isNull());
    assertEquals("=r1", week.get("robots").get(0).get("name").stringValue());
    assertEquals(1200, week.get("robots").get(0).at("/seconds/WORKING").asDouble());
  }

  @ParameterizedTest
  @CsvSource({"today, 1, HOUR", "7d, 7, DAY", "30d, 30, DAY"})
  void aPeriodThatHasANameEndsToday(String name, int days, String step) {
    JsonNode period = JSON.readTree(clerk.get("api/v1/statistics?period=" + name).body());

    Instant from = Instant.parse(period.get("from").stringValue());
    Instant until = Instant.parse(period.get("until").stringValue());
    assertEquals(step, period.get("step").stringValue());
    assertEquals("UTC", period.get("zone").stringValue());
    assertEquals(until, from.plusSeconds(86_400L * days));
    assertTrue(until.isAfter(Instant.now()));
  }

  @Test
  void twelveMonthsBeginWithAMonth() {
    JsonNode period = JSON.readTree(clerk.get("api/v1/statistics?period=12m").body());

    LocalDate first =
        Instant.parse(period.get("from").stringValue()).atOffset(ZoneOffset.UTC).toLocalDate();
    assertEquals(1, first.getDayOfMonth());
    assertEquals("MONTH", period.get("step").stringValue());
    assertEquals(12, period.get("series").size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          period=year                   | period | The period must be one of: today, 7d, 30d, 12m.
          from=2026-11-21               | to     | Enter the first and the last day
          to=2026-11-21                 | from   | Enter the first and the last day
          from=1&to=2026-11-21          | from   | Enter the first and the last day
          from=2026-02-30&to=2026-11-21 | from   | Enter the first and the last day
          from=1999-12-31&to=2000-01-01 | from   | in the years 2000 to 9998
          from=2026-01-01&to=%2B999999999-12-31 | to | in the years 2000 to 9998
          from=2026-11-21&to=2026-11-20 | to     | The last day is before the first.
          from=2020-01-01&to=2025-01-01 | to     | longer than 5 years
          zone=Nowhere/Land             | zone   | Unknown time zone.
          zone=%00                      | zone   | Unknown time zone.
          """)
  void aPeriodThatCannotBeIsSaidInASentence(String query, String field, String sentence) {
    for (String path : List.of("statistics", "statistics/series.csv", "statistics/robots.csv")) {
      HttpResponse<String> answer = clerk.get("api/v1/" + path + "?" + query);

      assertEquals(422, answer.statusCode(), path);
      assertEquals(
          "application/problem+json", answer.headers().firstValue("Content-Type").orElseThrow());
      JsonNode error = JSON.readTree(answer.body()).get("errors").get(0);
      assertEquals(field, error.get("field").stringValue());
      assertTrue(error.get("detail").stringValue().contains(sentence), answer.body());
    }
    HttpResponse<String> page = clerk.get("statistics?" + query);
    assertEquals(422, page.statusCode());
    assertTrue(page.body().contains(sentence), page.body());
  }

  @Test
  void theSeriesIsAFileForASpreadsheet() {
    HttpResponse<String> file = clerk.get("api/v1/statistics/series.csv?" + WEEK);

    assertEquals(
        "text/csv;header=present;charset=UTF-8",
        file.headers().firstValue("Content-Type").orElseThrow());
    assertEquals(
        "attachment; filename=\"toqa-series-2026-11-16-to-2026-11-22.csv\"",
        file.headers().firstValue("Content-Disposition").orElseThrow());
    List<String> lines = List.of(file.body().split("\r\n"));
    assertEquals(8, lines.size()); // the header, seven days
    assertEquals(
        "from,until,ordered,done,failed,cancelled,"
            + "waiting_tasks,waiting_mean_s,waiting_median_s,waiting_p90_s,"
            + "delivery_tasks,delivery_mean_s,delivery_median_s,delivery_p90_s,"
            + "completion_tasks,completion_mean_s,completion_median_s,completion_p90_s,"
            + "distance_m,battery_used_percent,task.robot-failed,task.robot-lost,"
            + "task.robot-withdrawn,task.robot-charges,task.late,traffic.standstill,"
            + "robot.charger-fails,"
            + "order_error_tasks,order_error_mean_s,order_error_median_s,order_error_p90_s,"
            + "start_error_tasks,start_error_mean_s,start_error_median_s,start_error_p90_s",
        lines.getFirst());
    assertEquals(
        "2026-11-19T00:00:00+01:00,2026-11-20T00:00:00+01:00,"
            + "0,0,0,0,0,,,,0,,,,0,,,,0.000,0.000,0,0,0,0,0,0,0,0,,,,0,,,",
        lines.get(4));
    assertEquals(
        "2026-11-20T00:00:00+01:00,2026-11-21T00:00:00+01:00,4,2,0,1,"
            + "2,20.000,10.000,30.000,2,110.000,60.000,160.000,2,210.000,120.000,300.000,"
            + "150.000,2.500,1,0,1,0,0,0,0,0,,,,0,,,", // 100 * (0.02 + 0.005) of a battery
        lines.get(5));
  }

  @Test
  void aNameThatASpreadsheetWouldTakeForAFormulaIsDisarmed() {
    HttpResponse<String> file = clerk.get("api/v1/statistics/robots.csv?" + WEEK);

    assertEquals(
        List.of(
            "robot,recorded_s,working_s,travelling_s,charging_s,idle_s,held_s,troubled_s,lost_s,"
                + "out_of_service_s,distance_m,battery_used_percent",
            "'=r1,1800.000,1200.000,0.000,0.000,600.000,0.000,0.000,0.000,0.000,120.000,2.000",
            "\"r2, \"\"old\"\"\",1800.000,0.000,600.000,1200.000,0.000,0.000,0.000,0.000,0.000,"
                + "30.000,0.500"),
        List.of(file.body().split("\r\n")));
  }

  @Test
  void thePageShowsFiguresAndATableForEachChart() {
    String page = clerk.get("statistics?" + WEEK).body();

    assertTrue(page.contains("Nov 16, 2026 – Nov 22, 2026, time zone Europe/Paris"), page);
    assertTrue(page.contains("<p class=\"figure\">60 s</p>"), page); // median of 60 s and 160 s
    for (String chart :
        List.of("Tasks", "Time to delivery", "Waiting time", "Distance", "Robot utilisation")) {
      assertTrue(page.contains(">" + chart + "</h2>"), chart);
    }
    assertTrue(
        page.replaceAll(">\\s+<", "><")
            .contains(
                "<th scope=\"row\">Nov 20</th><td class=\"number\" data-value=\"4.0\">4</td>"),
        page);
    assertTrue(page.contains("data-value=\"0.6666666666666666\">66.7%</td>"), "1200 s of 1800 s");
    assertTrue(page.contains("kind=task.robot-failed"), "failures lead to the history");
    assertTrue(
        page.matches("(?s).*Failures</p>\\s*<p class=\"figure\">1</p>.*"),
        "what was meant so is no failure");
    assertTrue(
        page.matches("(?s).*id=\"planned\">.*kind=task.robot-withdrawn[^>]*>[^<]*</a>: 1</li>.*"),
        "but it is told");
    assertTrue(page.contains("<details open>"), "without JavaScript the tables are seen");
    assertFalse(page.contains("style="), "the policy allows no style in a page");
  }

  @Test
  void aPeriodWithoutAnythingSaysSo() {
    String page = clerk.get("statistics?from=2025-01-01&to=2025-01-07").body();

    assertTrue(page.contains("No tasks were created or ended in this period."));
    assertTrue(page.contains("No robots were recorded in this period."));
    assertTrue(page.contains("No failures in this period."));
    assertFalse(page.contains("<canvas"));
  }

  @Test
  void anHourThatComesTwiceIsToldApart() {
    WorkHistory work = WorkHistory.in(server);
    work.addTask(Instant.parse("2026-10-25T00:30:00Z")); // 2:30 in summer time
    work.addTask(Instant.parse("2026-10-25T01:30:00Z")); // 2:30 again
    String query = "statistics?from=2026-10-25&to=2026-10-25&zone=Europe/Paris";

    JsonNode hours = JSON.readTree(clerk.get("api/v1/" + query).body()).get("series");
    String page = clerk.get(query).body();

    assertEquals(25, hours.size());
    assertEquals(1, hours.get(2).get("ordered").asInt());
    assertEquals(1, hours.get(3).get("ordered").asInt());
    assertTrue(page.contains("02:00 (+02:00)") && page.contains("02:00 (+01:00)"), page);
    assertTrue(page.contains(">03:00<"), page);
  }

  @ParameterizedTest
  @ValueSource(strings = {"period=7d", "period=today", "from=2026-11-16&to=2026-11-22"})
  void thePeriodThatIsShownIsMarked(String query) {
    String page = clerk.get("statistics?" + query).body();

    String marked = "period=" + query.replace("period=", "") + "\" aria-current=\"page\"";
    assertEquals(query.startsWith("period"), page.contains(marked), page);
  }

  @Test
  void anonymousCallersSeeNoFigures() {
    try (TestClient stranger = new TestClient(server.root())) {
      assertEquals(401, stranger.get("api/v1/statistics").statusCode());
      assertEquals(401, stranger.get("api/v1/statistics/robots.csv").statusCode());
      assertEquals(303, stranger.get("statistics").statusCode());
    }
  }
}
