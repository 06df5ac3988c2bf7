package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.toqa.fleet.RelayChain;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.RobotOrderReader;
import org.toqa.web.input.RobotQueryReader;

/** All robots; managers add some. */
public final class RobotsPage extends PageHandler {
  private static final int PAGE_SIZE = 50;

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
    List<RobotView> all = services(request).fleet().snapshots().latest().robots();
    RobotQueryReader query =
        new RobotQueryReader(request, errors, services(request).fleet().floors());
    List<RobotView> wanted = query.filter(all);
    request.setAttribute("count", wanted.size());
    request.setAttribute("isFiltered", query.isFiltered());
    request.setAttribute("states", RobotState.values());
    List<RobotView> shown = ListPage.of(request, wanted.size(), PAGE_SIZE).of(wanted);
    request.setAttribute("robots", shown);
    request.setAttribute(
        "relays",
        shown.stream()
            .collect(Collectors.toMap(RobotView::name, robot -> RelayChain.of(robot, all))));
    request.setAttribute("gateways", services(request).fleet().gateways());
  }
}
