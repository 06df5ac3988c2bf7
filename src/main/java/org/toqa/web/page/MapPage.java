package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.grid.FloorMap;
import org.toqa.web.Services;

/** The live map; its scripts draw it from the API. */
public final class MapPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    request.setAttribute("floorViews", services(request).fleet().snapshots().latest().floors());
    request.setAttribute("allocators", services(request).fleet().snapshots().latest().allocators());
    request.setAttribute(
        "cameras",
        services(request).cameras().all().stream()
            .filter(camera -> camera.floor() != null)
            .toList());
    request.setAttribute("supervised", supervised(request));
    request.setAttribute("robotStates", RobotState.values());
    show(request, response, "map");
  }

  /** Floors on which a supervisor works or has worked, or a robot with cameras could be one. */
  private static List<String> supervised(HttpServletRequest request) {
    Services services = services(request);
    Stream<String> seeing =
        services.fleet().snapshots().latest().robots().stream()
            .filter(robot -> robot.telemetry().readings().camera() != null)
            .map(RobotView::floor);
    Stream<String> worked =
        services.fleet().floors().stream()
            .map(FloorMap::name)
            .filter(floor -> services.supervisor().latest(floor).isPresent());
    return Stream.concat(seeing, worked).distinct().sorted().toList();
  }
}
