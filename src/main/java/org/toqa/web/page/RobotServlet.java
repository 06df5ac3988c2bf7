package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
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

/** One robot: its state, and a manager's word where it is and what it shall do. */
public final class RobotServlet extends PageServlet {
  private static final int TRACK_HOURS = 4;

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (addRobotAttributes(request).isPresent()) {
      show(request, response, "robot");
    } else {
      sendNotFound(request, response, "problem.noSuchRobot");
    }
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<RobotView> now = addRobotAttributes(request);
    if (now.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchRobot");
      return;
    }
    request.setAttribute("sent", RequestPath.lastSegment(request));
    FieldErrors differences = differences(now.get(), request);
    if (!differences.isEmpty()) {
      showConflict(request, response, "robot", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    Optional<RobotView> robot =
        command(request, errors).flatMap(answer -> awaitAnswer(request, answer, errors));
    if (robot.isPresent()) {
      boolean isRemoved = RequestPath.lastSegment(request).equals("remove");
      redirect(
          request, response, isRemoved ? "/robots?done=removed" : "/robots/" + robot.get().name());
    } else {
      showAgain(request, response, "robot", errors);
    }
  }

  private static FieldErrors differences(RobotView robot, HttpServletRequest request) {
    Texts texts = Texts.of(request);
    return new EditConflict(request, Version.of(robot))
        .compareText("host", robot.host(), "")
        .compareNumber("port", robot.port(), String.valueOf(robot.port()))
        .compareNumber("maxLoad", robot.maxLoad(), texts.get("common.kilograms", robot.maxLoad()))
        .compareText("parking", robot.parking(), texts.get("robot.parking.none"))
        .differences();
  }

  /** The wish of the form that was sent, if its fields are right. */
  private Optional<CompletionStage<Answer<RobotView>>> command(
      HttpServletRequest request, FieldErrors errors) {
    Fleet fleet = services().fleet();
    String name = RequestPath.parameter(request, "name");
    String user = Caller.of(request).name();
    return switch (RequestPath.lastSegment(request)) {
      case "out-of-service" -> Optional.of(fleet.takeOutOfService(name, user));
      case "in-service" -> Optional.of(fleet.putInService(name, user));
      case "hold" -> Optional.of(fleet.holdRobot(name, user));
      case "resume" -> Optional.of(fleet.resumeRobot(name, user));
      case "home" -> Optional.of(fleet.sendHome(name, user));
      case "remove" -> Optional.of(fleet.removeRobot(name, user));
      case "change" -> change(request, errors).map(change -> fleet.changeRobot(name, change, user));
      case "pair" -> pairing(request, errors).map(order -> fleet.pairRobot(name, order, user));
      default -> pose(request, errors).map(pose -> fleet.locateRobot(name, pose, user));
    };
  }

  private static Optional<PairingOrder> pairing(HttpServletRequest request, FieldErrors errors) {
    FormFields fields = new FormFields(request, errors);
    return new PairingFields(fields.text("host"), fields.number("port"), fields.text("code"))
        .read(Texts.of(request), errors);
  }

  private static Optional<RobotChange> change(HttpServletRequest request, FieldErrors errors) {
    FormFields fields = new FormFields(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    RobotChange change =
        new RobotChange(
            rules.host("host", fields.text("host")),
            rules.port("port", fields.number("port")),
            rules.load("maxLoad", fields.number("maxLoad")),
            fields.text("parking"));
    return errors.isEmpty() ? Optional.of(change) : Optional.empty();
  }

  private static Optional<RobotView> awaitAnswer(
      HttpServletRequest request, CompletionStage<Answer<RobotView>> answer, FieldErrors errors) {
    return acceptedValue(request, FleetAnswers.await(answer), errors);
  }

  /** The form has degrees. */
  private static Optional<Pose> pose(HttpServletRequest request, FieldErrors errors) {
    FormFields fields = new FormFields(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    Pose pose =
        new Pose(
            rules.coordinate("x", fields.number("x")),
            rules.coordinate("y", fields.number("y")),
            Math.toRadians(rules.angle("heading", fields.number("heading"))));
    return errors.isEmpty() ? Optional.of(pose) : Optional.empty();
  }

  private Optional<RobotView> addRobotAttributes(HttpServletRequest request) {
    String name = RequestPath.parameter(request, "name");
    FleetSnapshot fleet = services().fleet().snapshots().latest();
    Optional<RobotView> robot =
        fleet.robots().stream().filter(r -> r.name().equals(name)).findFirst();
    robot.ifPresent(
        r -> {
          request.setAttribute("robot", r);
          request.setAttribute("version", Version.of(r));
        });
    request.setAttribute("floors", services().fleet().floors());
    request.setAttribute("trackHours", TRACK_HOURS);
    request.setAttribute(
        "keepsPlace",
        fleet.floors().stream().anyMatch(floor -> floor.silentRobotCells().containsKey(name)));
    return robot;
  }
}
