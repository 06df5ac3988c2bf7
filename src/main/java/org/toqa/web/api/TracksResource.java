package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.history.FloorScenes;
import org.toqa.fleet.history.FloorTracks;
import org.toqa.fleet.history.LoadPlace;
import org.toqa.fleet.history.PlannedPath;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.fleet.history.TrackStore;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;

/** Where the robots and loads of a floor were in a period, and their paths, for replays. */
public final class TracksResource extends ApiHandler {
  private static final Duration MAX_DURATION = Duration.ofHours(1);
  private static final Duration DEFAULT_DURATION = Duration.ofMinutes(10);

  /** As JSON they have less than a megabyte. */
  private static final int MAX_POINTS = 30_000;

  /** Of loads' places, and of planned paths. */
  private static final int MAX_SCENES = 5_000;

  private record Span(Instant from, Instant until) {}

  private record TracksJson(
      String floor,
      Instant from,
      Instant until,
      List<TrackJson> robots,
      List<LoadJson> loads,
      List<PathJson> paths) {}

  /**
   * @param points milliseconds after {@code from}, x and y in metres, map frame
   */
  private record TrackJson(String robot, List<double[]> points) {}

  /**
   * @param from milliseconds after {@code from} of all; below 0 where it began before
   * @param until likewise; null: it still is
   * @param at metres, map frame; null: on its robots
   */
  private record LoadJson(
      long load,
      long task,
      long from,
      @Nullable Long until,
      @Nullable Vec2 at,
      List<String> robots,
      @Nullable LoadSize size) {
    static LoadJson of(LoadPlace place, Instant begin) {
      return new LoadJson(
          place.load(),
          place.task(),
          after(begin, place.from()),
          place.until() == null ? null : Long.valueOf(after(begin, place.until())),
          place.position(),
          place.robots(),
          place.size());
    }
  }

  /**
   * @param from milliseconds after {@code from} of all; below 0 where it began before
   * @param until likewise; null: it still is
   * @param points x and y in metres, map frame
   */
  private record PathJson(String robot, long from, @Nullable Long until, List<double[]> points) {
    static PathJson of(PlannedPath path, Instant begin) {
      return new PathJson(
          path.robot(),
          after(begin, path.from()),
          path.until() == null ? null : Long.valueOf(after(begin, path.until())),
          path.points().stream().map(point -> new double[] {point.x(), point.y()}).toList());
    }
  }

  private static long after(Instant begin, Instant moment) {
    return Duration.between(begin, moment).toMillis();
  }

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
    FloorScenes scenes =
        services(request).scenes().scenesOf(floor, span.from(), span.until(), MAX_SCENES);
    FloorTracks tracks = store.tracksOf(robots, span.from(), scenes.until(), MAX_POINTS);
    Json.send(
        request,
        response,
        200,
        new TracksJson(
            floor,
            span.from(),
            tracks.until(),
            tracks.points().entrySet().stream().map(track -> json(track, span.from())).toList(),
            scenes.loads().stream()
                .filter(load -> load.from().isBefore(tracks.until()))
                .map(load -> LoadJson.of(load, span.from()))
                .toList(),
            scenes.paths().stream()
                .filter(path -> path.from().isBefore(tracks.until()))
                .map(path -> PathJson.of(path, span.from()))
                .toList()));
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
                      after(from, point.at()), point.position().x(), point.position().y()
                    })
            .toList());
  }
}
