package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotView;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;
import org.toqa.web.input.RobotOrderReader;

/** All robots by name, and new ones. */
public final class RobotsResource extends ApiHandler {
  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(
        request,
        response,
        200,
        wantedFloor(request)
            .filter(services(request).fleet().snapshots().latest().robots(), RobotView::floor)
            .stream()
            .map(RobotJson::of)
            .toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    RobotOrder order = readBody(request, RobotOrderReader::readOrder);
    RobotView robot =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request).fleet().addRobot(order, Caller.of(request).name())));
    response.setHeader(
        "Location",
        request.getContextPath() + "/api/v1/robots/" + RequestPath.segment(robot.name()));
    Json.send(request, response, HttpServletResponse.SC_CREATED, RobotJson.of(robot));
  }
}
