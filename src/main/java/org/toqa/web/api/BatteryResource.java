package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.history.BatteryLevel;

/** How full a robot's battery was in the last hours. */
public final class BatteryResource extends ApiHandler {

  private record BatteryJson(String robot, List<LevelJson> levels) {}

  private record LevelJson(Instant at, double level) {
    static LevelJson of(BatteryLevel level) {
      return new LevelJson(level.at(), level.level());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    RobotView robot = RobotResource.robot(request);
    FleetSnapshot fleet = services(request).fleet().snapshots().latest();
    Instant since = fleet.at().minus(Duration.ofHours(TrackResource.hours(request)));
    Json.send(
        request,
        response,
        200,
        new BatteryJson(
            robot.name(),
            services(request).tracks().batteryLevels(robot.name(), since).stream()
                .map(LevelJson::of)
                .toList()));
  }
}
