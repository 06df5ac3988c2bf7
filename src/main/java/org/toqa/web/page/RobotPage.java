package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RelayChain;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Fields;
import org.toqa.web.input.RobotCommand;
import org.toqa.web.input.RobotOrderReader;
import org.toqa.web.input.Version;

/** One robot: its state, and the commands that a manager may give. */
public final class RobotPage extends PageHandler {
  private static final int TRACK_HOURS = 4;

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (addRobotAttributes(request).isPresent()) {
      show(request, response, "robot");
    } else {
      sendNotFound(request, response, "problem.noSuchRobot");
    }
  }

  public static void takeOutOfService(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "out-of-service", Fleet::takeOutOfService);
  }

  public static void putInService(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "in-service", Fleet::putInService);
  }

  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "hold", Fleet::holdRobot);
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "resume", Fleet::resumeRobot);
  }

  public static void clear(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "clear", form(RobotOrderReader::readReasons), Fleet::clearStops);
  }

  public static void sendHome(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "home", Fleet::sendHome);
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "remove", Fleet::removeRobot);
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(
        request,
        response,
        "change",
        form(RobotOrderReader::readChange),
        (fleet, robot, change, user) -> fleet.changeRobot(robot, change, seen(request), user));
  }

  /** What the entries of the form were compared with; null where it does not say its version. */
  private static @Nullable RobotChange seen(HttpServletRequest request) {
    return request.getParameter("version") == null
        ? null
        : ((RobotView) request.getAttribute("robot")).record().toChange();
  }

  public static void pair(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(request, response, "pair", RobotOrderReader::readPairing, Fleet::pairRobot);
  }

  public static void locate(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(
        request, response, "locate", form(RobotOrderReader::readEnteredPose), Fleet::locateRobot);
  }

  public static void move(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    command(
        request,
        response,
        "move",
        form(fields -> RobotOrderReader.readMove(fields, RobotOrderReader::readEnteredPose)),
        Fleet::moveRobot);
  }

  private static void command(
      HttpServletRequest request, HttpServletResponse response, String form, RobotCommand command)
      throws ServletException, IOException {
    send(request, response, form, fields -> Optional.of(command));
  }

  private static <T> void command(
      HttpServletRequest request,
      HttpServletResponse response,
      String form,
      Function<Fields, Optional<T>> reader,
      RobotCommand.With<T> command)
      throws ServletException, IOException {
    send(request, response, form, fields -> reader.apply(fields).map(command::of));
  }

  /**
   * @param form names the form that was sent, where the page shows it again
   * @param reader answers nothing, with a sentence in the errors, where a field is wrong
   */
  private static void send(
      HttpServletRequest request,
      HttpServletResponse response,
      String form,
      Function<Fields, Optional<RobotCommand>> reader)
      throws ServletException, IOException {
    Optional<RobotView> now = addRobotAttributes(request);
    if (now.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchRobot");
      return;
    }
    request.setAttribute("sent", form);
    FieldErrors differences = differences(now.get(), request);
    if (!differences.isEmpty()) {
      showConflict(request, response, "robot", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    Fleet fleet = services(request).fleet();
    String name = now.get().name();
    String user = Caller.of(request).name();
    Optional<RobotView> robot =
        reader
            .apply(new FormFields(request, errors))
            .map(command -> FleetAnswers.await(command.send(fleet, name, user)))
            .flatMap(answer -> acceptedValue(request, answer, errors));
    if (robot.isPresent()) {
      boolean isRemoved = form.equals("remove");
      redirect(
          request, response, isRemoved ? "/robots?done=removed" : "/robots/" + robot.get().name());
    } else {
      showAgain(request, response, "robot", errors);
    }
  }

  /** Nothing where the reader has filed a sentence. */
  private static <T> Function<Fields, Optional<T>> form(Function<Fields, T> reader) {
    return fields -> {
      T read = reader.apply(fields);
      return fields.errors().isEmpty() ? Optional.of(read) : Optional.empty();
    };
  }

  private static FieldErrors differences(RobotView robot, HttpServletRequest request) {
    Texts texts = Texts.of(request);
    RobotRecord stored = robot.record();
    return new EditConflict(request, Version.of(robot))
        .compareText("host", stored.host(), "")
        .compareNumber("port", stored.port(), String.valueOf(stored.port()))
        .compareNumber("maxLoad", robot.maxLoad(), texts.get("common.kilograms", robot.maxLoad()))
        .compareText("parking", stored.parking(), texts.get("robot.parking.none"))
        .compareText("gateway", stored.gateway(), texts.get("robot.gateway.none"))
        .differences();
  }

  /** For the view "robot"; empty: there is none of the name in the path. */
  static Optional<RobotView> addRobotAttributes(HttpServletRequest request) {
    String name = RequestPath.parameter(request, "name");
    FleetSnapshot fleet = services(request).fleet().snapshots().latest();
    Optional<RobotView> robot =
        fleet.robots().stream().filter(r -> r.name().equals(name)).findFirst();
    robot.ifPresent(
        r -> {
          request.setAttribute("robot", r);
          request.setAttribute("relays", RelayChain.of(r, fleet.robots()));
          request.setAttribute("version", Version.of(r));
          ReadingForms.addAttributes(request, r.name());
          request.setAttribute(
              "ranges",
              RangePicture.of(r.telemetry().readings().ranges(), r.capabilities().sensorRange()));
          Instant since = fleet.at().minus(Duration.ofHours(TRACK_HOURS));
          request.setAttribute(
              "batteryPicture",
              BatteryPicture.of(
                  services(request).tracks().batteryLevels(name, since), since, fleet.at()));
        });
    request.setAttribute("gateways", services(request).fleet().gateways());
    request.setAttribute("trackHours", TRACK_HOURS);
    request.setAttribute(
        "keepsPlace",
        fleet.floors().stream().anyMatch(floor -> floor.silentRobotCells().containsKey(name)));
    return robot;
  }
}
