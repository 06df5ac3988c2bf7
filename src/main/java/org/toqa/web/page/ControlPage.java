package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.fleet.ManualOrder;
import org.toqa.fleet.RobotView;
import org.toqa.web.RequestPath;

/** What one robot does at this moment, with the buttons that start, stop and drive it. */
public final class ControlPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    String name = RequestPath.parameter(request, "name");
    Optional<RobotView> robot =
        services(request).fleet().snapshots().latest().robots().stream()
            .filter(r -> r.name().equals(name))
            .findFirst();
    if (robot.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchRobot");
      return;
    }
    request.setAttribute("robot", robot.get());
    request.setAttribute("cameras", services(request).cameras().ofRobot(name));
    request.setAttribute("hasReadings", services(request).telemetry() != null);
    request.setAttribute("manualSpeed", ManualOrder.MAX_SPEED);
    request.setAttribute("manualTurnRate", ManualOrder.MAX_TURN_RATE);
    show(request, response, "control");
  }
}
