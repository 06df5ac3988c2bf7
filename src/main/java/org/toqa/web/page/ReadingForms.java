package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Objects;
import java.util.Optional;
import org.toqa.fleet.RobotView;
import org.toqa.telemetry.ReadingLimits;
import org.toqa.telemetry.Telemetry;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.ReadingLimitsReader;

/** What a manager decides, on a robot's page, of what it publishes by MQTT. */
public final class ReadingForms extends PageHandler {
  private static final String PASSWORD = "mqttPassword";

  /** For the view "robot". */
  static void addAttributes(HttpServletRequest request, String robot) {
    Telemetry telemetry = services(request).telemetry();
    if (telemetry == null) {
      return;
    }
    request.setAttribute("broker", telemetry.broker());
    request.setAttribute("mqttUser", telemetry.user(robot));
    request.setAttribute("published", telemetry.readings(robot));
    request.setAttribute("limits", telemetry.limits(robot));
    if (Caller.of(request).mayManage()) {
      request.setAttribute("hasMqttPassword", telemetry.hasPassword(robot));
      ShownOnce.of(request.getServletContext())
          .take(Caller.of(request), PASSWORD + robot)
          .ifPresent(password -> request.setAttribute(PASSWORD, password));
    }
  }

  public static void setLimits(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<RobotView> robot = robot(request, response);
    if (robot.isEmpty()) {
      return;
    }
    String name = robot.get().name();
    request.setAttribute("sent", "limits");
    FieldErrors errors = new FieldErrors();
    Optional<ReadingLimits> limits =
        readForm(
            request,
            errors,
            fields ->
                ReadingLimitsReader.read(
                    name, Objects.requireNonNullElse(fields.text("reading"), ""), fields));
    if (limits.isPresent()) {
      Objects.requireNonNull(services(request).telemetry()).setLimits(limits.get());
      redirect(request, response, "/robots/" + name + "#readings");
    } else {
      showAgain(request, response, "robot", errors);
    }
  }

  public static void makePassword(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<RobotView> robot = robot(request, response);
    if (robot.isEmpty()) {
      return;
    }
    String name = robot.get().name();
    Telemetry telemetry = Objects.requireNonNull(services(request).telemetry());
    if (telemetry.broker().isEmbedded()) {
      String password = telemetry.makePassword(name, Caller.of(request).name()).password();
      ShownOnce.of(request.getServletContext()).put(Caller.of(request), PASSWORD + name, password);
    }
    redirect(request, response, "/robots/" + name + "#readings");
  }

  /** The robot in the path; empty when the answer is given: there is none, or there is no MQTT. */
  private static Optional<RobotView> robot(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    if (services(request).telemetry() == null) {
      sendNotFound(request, response, "problem.noMqtt");
      return Optional.empty();
    }
    Optional<RobotView> robot = RobotPage.addRobotAttributes(request);
    if (robot.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchRobot");
    }
    return robot;
  }
}
