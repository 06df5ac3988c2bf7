package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.history.FloorTracks;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.fleet.history.TrackStore;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;

/** Where the robots of a floor were in a period, for replays. */
public final class TracksResource extends ApiHandler {
  private static final Duration MAX_DURATION = Duration.ofHours(1);
  private static final Duration DEFAULT_DURATION = Duration.ofMinutes(10);

  /** As JSON they have less than a megabyte. */
  private static final int MAX_POINTS = 30_000;

  private record Span(Instant from, Instant until) {}

  private record TracksJson(String floor, Instant from, Instant until, List<TrackJson> robots) {}

  /**
   * @param points milliseconds after {@code from}, x and y in metres, map frame
   */
  private record TrackJson(String robot, List<double[]> points) {}

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = floor(request).name();
    Span span = span(request);
    Stream<String> present =
        services(request).fleet().snapshots().latest().robots().stream()
            .filter(robot -> robot.floor().equals(floor))
            .map(RobotView::name);
    TrackStore store = services(request).tracks();
    List<String> robots =
        Stream.concat(present, store.robotsOf(floor).stream()).distinct().toList();
    FloorTracks tracks = store.tracksOf(robots, span.from(), span.until(), MAX_POINTS);
    Json.send(
        request,
        response,
        200,
        new TracksJson(
            floor,
            span.from(),
            tracks.until(),
            tracks.points().entrySet().stream().map(track -> json(track, span.from())).toList()));
  }

  private static Span span(HttpServletRequest request) {
    FieldErrors errors = new FieldErrors();
    InputRules rules = new InputRules(Texts.of(request), errors);
    Instant end = rules.moment("until", request.getParameter("until"));
    Instant until = end == null ? services(request).fleet().snapshots().latest().at() : end;
    Instant begin = rules.moment("from", request.getParameter("from"));
    Instant from = begin == null ? until.minus(DEFAULT_DURATION) : begin;
    if (errors.isEmpty()
        && (!from.isBefore(until) || Duration.between(from, until).compareTo(MAX_DURATION) > 0)) {
      errors.add("until", Texts.of(request).get("error.tracks.period"));
    }
    throwIfAny(errors);
    return new Span(from, until);
  }

  private static TrackJson json(Map.Entry<String, List<TrackPoint>> track, Instant from) {
    return new TrackJson(
        track.getKey(),
        track.getValue().stream()
            .map(
                point ->
                    new double[] {
                      Duration.between(from, point.at()).toMillis(),
                      point.position().x(),
                      point.position().y()
                    })
            .toList());
  }
}
