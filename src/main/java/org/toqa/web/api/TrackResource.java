package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.history.TrackPoint;

/** Where a robot was in the last hours. */
public final class TrackResource extends ApiHandler {
  private static final int DEFAULT_HOURS = 4;
  private static final int MAX_HOURS = 168;

  private record TrackJson(String robot, List<PointJson> points) {}

  /** Metres, map frame. */
  private record PointJson(Instant at, double x, double y) {
    static PointJson of(TrackPoint point) {
      return new PointJson(point.at(), point.position().x(), point.position().y());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String robot = RobotResource.robot(request).name();
    FleetSnapshot fleet = services(request).fleet().snapshots().latest();
    Instant since = fleet.at().minus(Duration.ofHours(hours(request)));
    Json.send(
        request,
        response,
        200,
        new TrackJson(
            robot,
            services(request).tracks().track(robot, since).stream().map(PointJson::of).toList()));
  }

  /** Of which past the request asks. */
  static int hours(HttpServletRequest request) {
    return queryNumber(request, "hours", DEFAULT_HOURS, 1, MAX_HOURS);
  }
}
