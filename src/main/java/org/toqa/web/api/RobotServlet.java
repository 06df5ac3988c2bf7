package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.FleetAnswers;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** One robot; and a person's word where it is. */
public final class RobotServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String name = Doors.parameter(request, "name");
    RobotView robot =
        services().fleet().feed().latest().robots().stream()
            .filter(r -> r.name().equals(name))
            .findFirst()
            .orElseThrow(
                () -> Problem.of(404, Texts.of(request).get("problem.noSuchRobot")).raised());
    Json.send(response, 200, RobotJson.of(robot));
  }

  /** The only write here is locate. */
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    Pose pose =
        new Pose(
            rules.coordinate("x", fields.number("x")),
            rules.coordinate("y", fields.number("y")),
            rules.angle("theta", fields.number("theta")));
    fields.refuseUnknown();
    refuseIfAny(errors);
    RobotView robot =
        accepted(
            FleetAnswers.await(
                services()
                    .fleet()
                    .locate(Doors.parameter(request, "name"), pose, Caller.of(request).name())));
    Json.send(response, 200, RobotJson.of(robot));
  }
}
