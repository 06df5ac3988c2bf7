package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.RobotCommand;
import org.toqa.web.input.RobotOrderReader;
import org.toqa.web.input.Version;

/** One robot, and the commands that a manager may give. */
public final class RobotResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, robot(request));
  }

  /** That the request names. */
  static RobotView robot(HttpServletRequest request) {
    String name = RequestPath.parameter(request, "name");
    return services(request).fleet().snapshots().latest().robots().stream()
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

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    RobotView robot = robot(request);
    requireVersion(Version.of(robot), request);
    RobotChange change = readBody(request, RobotOrderReader::readChange);
    String user = Caller.of(request).name();
    send(
        request,
        response,
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request)
                    .fleet()
                    .changeRobot(robot.name(), change, seen(robot, request), user))));
  }

  /** What the caller says that he has read; null where he does not. */
  private static @Nullable RobotChange seen(RobotView robot, HttpServletRequest request) {
    String ifMatch = request.getHeader("If-Match");
    return ifMatch == null || ifMatch.strip().equals("*") ? null : robot.record().toChange();
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response) {
    await(request, Fleet::removeRobot);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void takeOutOfService(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    command(request, response, Fleet::takeOutOfService);
  }

  public static void putInService(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    command(request, response, Fleet::putInService);
  }

  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    command(request, response, Fleet::holdRobot);
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    command(request, response, Fleet::resumeRobot);
  }

  public static void clear(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Set<String> reasons = readBody(request, RobotOrderReader::readReasons);
    command(request, response, (fleet, robot, user) -> fleet.clearStops(robot, reasons, user));
  }

  public static void sendHome(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    command(request, response, Fleet::sendHome);
  }

  public static void pair(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    PairingOrder order = readBody(request, RobotOrderReader::readPairing).orElseThrow();
    command(request, response, (fleet, robot, user) -> fleet.pairRobot(robot, order, user));
  }

  public static void locate(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Pose pose = readBody(request, RobotOrderReader::readPosition);
    command(request, response, (fleet, robot, user) -> fleet.locateRobot(robot, pose, user));
  }

  public static void move(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    RobotMove move =
        readBody(request, fields -> RobotOrderReader.readMove(fields, RobotOrderReader::readPose));
    command(request, response, (fleet, robot, user) -> fleet.moveRobot(robot, move, user));
  }

  private static void command(
      HttpServletRequest request, HttpServletResponse response, RobotCommand command)
      throws IOException {
    Json.send(request, response, 200, RobotJson.of(await(request, command)));
  }

  private static RobotView await(HttpServletRequest request, RobotCommand command) {
    return acceptedValue(
        request,
        FleetAnswers.await(
            command.send(
                services(request).fleet(),
                RequestPath.parameter(request, "name"),
                Caller.of(request).name())));
  }
}
