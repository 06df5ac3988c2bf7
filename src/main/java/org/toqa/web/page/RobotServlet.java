package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.FleetAnswers;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** One robot: its state, and a manager's word where it is. */
public final class RobotServlet extends PageServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (offerRobot(request)) {
      show(request, response, "robot");
    } else {
      notFound(request, response, "problem.noSuchRobot");
    }
  }

  /** The only write here is locate; the form has degrees. */
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (!offerRobot(request)) {
      notFound(request, response, "problem.noSuchRobot");
      return;
    }
    FieldErrors errors = new FieldErrors();
    Optional<RobotView> robot =
        read(request, errors).flatMap(pose -> locate(pose, request, errors));
    if (robot.isPresent()) {
      goTo(request, response, "/robots/" + robot.get().name());
    } else {
      showAgain(request, response, "robot", errors);
    }
  }

  private Optional<RobotView> locate(Pose pose, HttpServletRequest request, FieldErrors errors) {
    String name = Doors.parameter(request, "name");
    String user = Caller.of(request).name();
    return accepted(FleetAnswers.await(services().fleet().locate(name, pose, user)), errors);
  }

  private static Optional<Pose> read(HttpServletRequest request, FieldErrors errors) {
    FormFields fields = new FormFields(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    Pose pose =
        new Pose(
            rules.coordinate("x", fields.number("x")),
            rules.coordinate("y", fields.number("y")),
            Math.toRadians(rules.angle("heading", fields.number("heading"))));
    return errors.isEmpty() ? Optional.of(pose) : Optional.empty();
  }

  private boolean offerRobot(HttpServletRequest request) {
    String name = Doors.parameter(request, "name");
    Optional<RobotView> robot =
        services().fleet().feed().latest().robots().stream()
            .filter(r -> r.name().equals(name))
            .findFirst();
    robot.ifPresent(r -> request.setAttribute("robot", r));
    return robot.isPresent();
  }
}
