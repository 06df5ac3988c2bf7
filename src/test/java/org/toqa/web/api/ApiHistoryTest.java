package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.history.BatteryLevel;
import org.toqa.fleet.history.LoadPlace;
import org.toqa.fleet.history.PlannedPath;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.testbed.Hall;
import org.toqa.wording.Sentence;
import tools.jackson.databind.JsonNode;

/** What the API says of the past: its history and the tracks of robots. */
class ApiHistoryTest extends ApiTestServer {
  @Test
  void theHistoryIsFilteredAndPaged() {
    Instant at = Instant.parse("2026-11-21T08:00:00Z");
    server
        .store()
        .addEvents(
            List.of(
                new EventRecord(at, "robot.held", null, "r1", "Max", Sentence.verbatim("one")),
                new EventRecord(at, "task.started", 7L, "r1", "toqa", Sentence.verbatim("two")),
                new EventRecord(at, "task.started", 8L, "r2", "toqa", Sentence.verbatim("three"))));

    JsonNode first = JSON.readTree(get("api/v1/history?robot=r1&limit=1").body());
    JsonNode second =
        JSON.readTree(get("api/v1/history?robot=r1&before=" + first.get("next").asLong()).body());

    assertEquals("two", first.get("events").get(0).get("text").stringValue());
    assertEquals("one", second.get("events").get(0).get("text").stringValue());
    assertTrue(second.get("next").isNull());
    assertEquals(
        1,
        JSON.readTree(get("api/v1/history?until=2026-11-21&task=8").body()).get("events").size());
    HttpResponse<String> wrong = get("api/v1/history?task=x&from=yesterday&kind=A");
    assertEquals(422, wrong.statusCode());
    assertEquals(3, JSON.readTree(wrong.body()).get("errors").size());
  }

  @Test
  void aRobotHasATrack() {
    server
        .fleet()
        .changeRobots(
            none -> List.of(Hall.robot("r1", RobotState.IDLE, new Pose(1, 1, 0), "h", 7275)));
    server.store().saveRobot(RobotRecord.direct("r1", "hall", "h", 7275, 5, null, false, null));
    Instant now = server.fleet().latest().at();
    server
        .tracks()
        .add(
            List.of(
                new TrackPoint("r1", now.minusSeconds(7200), new Vec2(1, 1)),
                new TrackPoint("r1", now.minusSeconds(60), new Vec2(2.5, 1))));

    JsonNode points = JSON.readTree(get("api/v1/tracks/r1?hours=1").body()).get("points");

    assertEquals(1, points.size());
    assertEquals(2.5, points.get(0).get("x").asDouble());
    assertEquals(404, get("api/v1/tracks/r9").statusCode());
  }

  @Test
  void aRobotHasABatteryOverTime() {
    server
        .fleet()
        .changeRobots(
            none -> List.of(Hall.robot("r1", RobotState.IDLE, new Pose(1, 1, 0), "h", 7275)));
    server
        .store()
        .saveRobot(new RobotRecord("r1", "hall", "h", 7275, 5, null, false, null, null, null));
    Instant now = server.fleet().latest().at();
    server
        .tracks()
        .addBatteryLevels(
            List.of(
                new BatteryLevel("r1", now.minusSeconds(9000), 0.9),
                new BatteryLevel("r1", now.minusSeconds(7200), 0.84),
                new BatteryLevel("r1", now.minusSeconds(60), 0.8)));

    JsonNode levels = JSON.readTree(get("api/v1/robots/r1/battery?hours=1").body()).get("levels");

    assertEquals(2, levels.size());
    assertEquals(0.84, levels.get(0).get("level").asDouble());
    assertEquals(404, get("api/v1/robots/r9/battery").statusCode());
  }

  @Test
  void aFloorHasTheTracksOfItsRobotsWithTheirLoadsAndPaths() {
    server.store().saveRobot(RobotRecord.direct("r1", "hall", "h", 7275, 5, null, false, null));
    Instant at = Instant.parse("2026-11-21T08:00:00Z");
    server
        .tracks()
        .add(
            List.of(
                new TrackPoint("r1", at.minusSeconds(60), new Vec2(1, 1)),
                new TrackPoint("r1", at.plusMillis(1500), new Vec2(2.125, 1)),
                new TrackPoint("r1", at.plusSeconds(7200), new Vec2(3, 1))));
    Instant pickedUp = at.plusSeconds(2);
    server
        .scenes()
        .save(
            List.of(
                new LoadPlace(
                    7, 8, "hall", at.minusSeconds(1), pickedUp, new Vec2(1, 2), List.of(), null),
                new LoadPlace(
                    7, 8, "hall", pickedUp, null, null, List.of("r1"), new LoadSize(0.5, 0.4))),
            List.of(
                new PlannedPath(
                    "r1",
                    "hall",
                    pickedUp,
                    at.plusSeconds(9),
                    List.of(new Vec2(2.125, 1), new Vec2(3, 1)))));

    JsonNode tracks =
        JSON.readTree(
            get("api/v1/tracks?floor=hall&from=2026-11-21T08:00:00Z&until=2026-11-21T09:00:00Z")
                .body());

    assertEquals("hall", tracks.get("floor").stringValue());
    assertEquals("2026-11-21T09:00:00Z", tracks.get("until").stringValue());
    assertEquals("r1", tracks.get("robots").get(0).get("robot").stringValue());
    assertEquals(
        "[[-60000.0,1.0,1.0],[1500.0,2.125,1.0],[7200000.0,3.0,1.0]]",
        tracks.get("robots").get(0).get("points").toString());
    assertEquals(
        """
        [{"load":7,"task":8,"from":-1000,"until":2000,"at":{"x":1.0,"y":2.0},"robots":[],"size":null},\
        {"load":7,"task":8,"from":2000,"until":null,"at":null,"robots":["r1"],\
        "size":{"length":0.5,"width":0.4}}]""",
        tracks.get("loads").toString());
    assertEquals(
        """
        [{"robot":"r1","from":2000,"until":9000,"points":[[2.125,1.0],[3.0,1.0]]}]""",
        tracks.get("paths").toString());
    JsonNode usual = JSON.readTree(get("api/v1/tracks").body());
    assertEquals(
        Duration.ofMinutes(10),
        Duration.between(
            Instant.parse(usual.get("from").stringValue()),
            Instant.parse(usual.get("until").stringValue())));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          floor=cellar | 404 | There is no floor with this name. Available: hall.
          from=yesterday | 422 | Enter a time with its offset from UTC, such as 2026-11-21T08:00:00Z.
          until=2026-11-21 | 422 | Enter a time with its offset from UTC, such as 2026-11-21T08:00:00Z.
          until=%2B999999999-01-01T00:00:00Z | 422 | Enter a time with its offset from UTC, such as 2026-11-21T08:00:00Z.
          from=1999-12-31T23:59:59Z | 422 | Enter a time with its offset from UTC, such as 2026-11-21T08:00:00Z.
          from=2026-11-21T08:00:00Z&until=2026-11-21T08:00:00Z | 422 | The period must end after it begins, and last at most one hour.
          from=2026-11-21T08:00:00Z&until=2026-11-21T09:00:01Z | 422 | The period must end after it begins, and last at most one hour.
          """)
  void aBadPeriodOfTracksGetsASentence(String query, int status, String sentence) {
    HttpResponse<String> answer = get("api/v1/tracks?" + query);

    assertEquals(sentence, detail(answer));
    assertEquals(status, answer.statusCode());
  }

  @Test
  void theTracksOfAHundredRobotsInAnHourAreBelowAMegabyte() {
    List<String> names = IntStream.rangeClosed(1, 100).mapToObj(i -> "r" + i).toList();
    Instant at = Instant.parse("2026-11-21T08:00:00Z");
    server
        .fleet()
        .changeRobots(
            none ->
                names.stream()
                    .map(name -> Hall.robot(name, RobotState.IDLE, new Pose(1, 1, 0), "h", 7275))
                    .toList());
    for (String name : names) {
      server.store().saveRobot(RobotRecord.direct(name, "hall", "h", 7275, 5, null, false, null));
    }
    server
        .tracks()
        .add(
            names.stream()
                .flatMap(
                    name ->
                        IntStream.range(0, 600) // one each six seconds
                            .mapToObj(
                                i ->
                                    new TrackPoint(
                                        name,
                                        at.plusSeconds(6L * i),
                                        new Vec2(100.001 + i / 7.0, 99.999))))
                .toList());

    HttpResponse<String> answer =
        get("api/v1/tracks?from=2026-11-21T08:00:00Z&until=2026-11-21T09:00:00Z");

    assertEquals(200, answer.statusCode());
    assertTrue(answer.body().length() < 1_000_000, () -> answer.body().length() + " bytes");
    assertEquals(
        "2026-11-21T08:30:00Z", // 300 points of each are 30,000
        JSON.readTree(answer.body()).get("until").stringValue());
  }
}
