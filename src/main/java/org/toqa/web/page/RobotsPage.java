package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotView;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.RobotOrderReader;

/** All robots; managers add some. */
public final class RobotsPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    addFleetAttributes(request, errors);
    showList(request, response, "robots", errors);
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Optional<RobotView> robot =
        readForm(request, errors, RobotOrderReader::readOrder)
            .flatMap(order -> add(order, request, errors));
    if (robot.isPresent()) {
      redirect(request, response, "/robots/" + robot.get().name());
    } else {
      addFleetAttributes(request, errors);
      showAgain(request, response, "robots", errors);
    }
  }

  private static Optional<RobotView> add(
      RobotOrder order, HttpServletRequest request, FieldErrors errors) {
    String user = Caller.of(request).name();
    return acceptedValue(
        request, FleetAnswers.await(services(request).fleet().addRobot(order, user)), errors);
  }

  private static void addFleetAttributes(HttpServletRequest request, FieldErrors errors) {
    request.setAttribute(
        "robots",
        wantedFloor(request, errors)
            .filter(services(request).fleet().snapshots().latest().robots(), RobotView::floor));
    request.setAttribute("gateways", services(request).fleet().gateways());
  }
}
