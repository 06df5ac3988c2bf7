package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.toqa.fleet.Answer;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.PairingFields;
import org.toqa.web.input.Version;

/** One robot; and a person's word where it is and what it shall do. */
public final class RobotServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, robot(request));
  }

  private RobotView robot(HttpServletRequest request) {
    String name = RequestPath.parameter(request, "name");
    return services().fleet().snapshots().latest().robots().stream()
        .filter(r -> r.name().equals(name))
        .findFirst()
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchRobot")).exception());
  }

  private static void send(
      HttpServletRequest request, HttpServletResponse response, RobotView robot)
      throws IOException {
    response.setHeader("ETag", Version.of(robot).tag());
    Json.send(request, response, 200, RobotJson.of(robot));
  }

  @Override
  protected void doPut(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    RobotView robot = robot(request);
    requireVersion(Version.of(robot), request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    RobotChange change =
        new RobotChange(
            rules.host("host", fields.text("host")),
            rules.port("port", fields.number("port")),
            rules.load("maxLoad", fields.number("maxLoad")),
            fields.text("parking"));
    fields.refuseUnknown();
    throwIfAny(errors);
    String user = Caller.of(request).name();
    send(
        request,
        response,
        acceptedValue(
            request,
            FleetAnswers.await(services().fleet().changeRobot(robot.name(), change, user))));
  }

  @Override
  protected void doDelete(HttpServletRequest request, HttpServletResponse response) {
    String robot = RequestPath.parameter(request, "name");
    acceptedValue(
        request,
        FleetAnswers.await(services().fleet().removeRobot(robot, Caller.of(request).name())));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String robot = RequestPath.parameter(request, "name");
    String user = Caller.of(request).name();
    CompletionStage<Answer<RobotView>> answer =
        switch (RequestPath.lastSegment(request)) {
          case "out-of-service" -> services().fleet().takeOutOfService(robot, user);
          case "in-service" -> services().fleet().putInService(robot, user);
          case "hold" -> services().fleet().holdRobot(robot, user);
          case "resume" -> services().fleet().resumeRobot(robot, user);
          case "home" -> services().fleet().sendHome(robot, user);
          case "pair" -> services().fleet().pairRobot(robot, pairing(request), user);
          default -> services().fleet().locateRobot(robot, pose(request), user);
        };
    Json.send(
        request, response, 200, RobotJson.of(acceptedValue(request, FleetAnswers.await(answer))));
  }

  private static PairingOrder pairing(HttpServletRequest request) throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    Optional<PairingOrder> order =
        new PairingFields(fields.text("host"), fields.number("port"), fields.text("code"))
            .read(Texts.of(request), errors);
    fields.refuseUnknown();
    throwIfAny(errors);
    return order.orElseThrow();
  }

  private static Pose pose(HttpServletRequest request) throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    Pose pose =
        new Pose(
            rules.coordinate("x", fields.number("x")),
            rules.coordinate("y", fields.number("y")),
            rules.angle("theta", fields.number("theta")));
    fields.refuseUnknown();
    throwIfAny(errors);
    return pose;
  }
}
