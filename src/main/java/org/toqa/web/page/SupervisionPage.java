package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import org.toqa.fleet.Answer;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.fleet.supervision.SupervisionOrder;
import org.toqa.fleet.supervision.Supervisor;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.SupervisionView;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.SupervisionOrderReader;

/** The supervisor of a floor, its workers and their boxes; managers let it begin and stop it. */
public final class SupervisionPage extends PageHandler {
  private static final String VIEW = "supervision";

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<String> floor = floor(request, response);
    if (floor.isPresent()) {
      addAttributes(request, floor.get());
      show(request, response, VIEW);
    }
  }

  /** The floor in the path; empty when the answer is given: there is none. */
  private static Optional<String> floor(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String name = RequestPath.parameter(request, "floor");
    if (services(request).fleet().floors().stream().anyMatch(f -> f.name().equals(name))) {
      return Optional.of(name);
    }
    sendNotFound(request, response, "floors.gone");
    return Optional.empty();
  }

  private static void addAttributes(HttpServletRequest request, String floor) {
    Optional<SupervisionView> view = SupervisionView.of(services(request), floor);
    List<RobotView> robots =
        services(request).fleet().snapshots().latest().robots().stream()
            .filter(robot -> robot.floor().equals(floor))
            .toList();
    request.setAttribute("floor", floor);
    request.setAttribute("segment", RequestPath.segment(floor));
    request.setAttribute("view", view.orElse(null));
    request.setAttribute("candidates", robots);
    request.setAttribute(
        "seeing",
        robots.stream()
            .filter(robot -> robot.telemetry().readings().camera() != null)
            .map(RobotView::name)
            .toList());
    request.setAttribute("mostBoxes", SupervisionOrder.MAX_BOXES);
    request.setAttribute("lastBoxes", view.map(last -> lines(last.supervision())).orElse(""));
  }

  /** Boxes of before that are to be carried still, as the form has them. */
  private static String lines(Supervision last) {
    return last.boxes().values().stream()
        .filter(box -> !box.delivered())
        .map(
            box ->
                String.format(
                    Locale.ROOT, "%d: %s, %s", box.number(), box.target().x(), box.target().y()))
        .collect(Collectors.joining("\n"));
  }

  public static void start(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<String> floor = floor(request, response);
    if (floor.isEmpty()) {
      return;
    }
    FieldErrors errors = new FieldErrors();
    Optional<Supervision> begun =
        readForm(request, errors, fields -> SupervisionOrderReader.read(fields, floor.get()))
            .flatMap(
                order ->
                    acceptedValue(
                        request,
                        FleetAnswers.await(
                            services(request).supervisor().start(order, Caller.of(request).name())),
                        errors));
    if (begun.isPresent()) {
      redirect(request, response, path(floor.get()) + "?done=started");
    } else {
      addAttributes(request, floor.get());
      showAgain(request, response, VIEW, errors);
    }
  }

  public static void stop(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(request, response, Supervisor::stop, "stopped");
  }

  public static void lookAgain(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(request, response, Supervisor::lookAgain, "looks");
  }

  public static void leaveOut(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    int box = SupervisionView.boxOfPath(request);
    change(
        request,
        response,
        (supervisor, floor, user) -> supervisor.leaveOut(floor, box, user),
        "left-out");
  }

  @FunctionalInterface
  private interface Change {
    CompletionStage<Answer<Supervision>> send(Supervisor supervisor, String floor, String user);
  }

  private static void change(
      HttpServletRequest request, HttpServletResponse response, Change change, String done)
      throws ServletException, IOException {
    Optional<String> floor = floor(request, response);
    if (floor.isEmpty()) {
      return;
    }
    Answer<Supervision> answer =
        FleetAnswers.await(
            change.send(services(request).supervisor(), floor.get(), Caller.of(request).name()));
    if (answer instanceof Answer.Unknown<Supervision>) {
      sendNotFound(request, response, "supervision.noBox");
      return;
    }
    FieldErrors errors = new FieldErrors();
    if (acceptedValue(request, answer, errors).isPresent()) {
      redirect(request, response, path(floor.get()) + "?done=" + done);
      return;
    }
    addAttributes(request, floor.get());
    request.setAttribute("refusals", List.copyOf(errors.sentences().values()));
    showConflict(request, response, VIEW, new FieldErrors());
  }

  private static String path(String floor) {
    return "/floors/" + RequestPath.segment(floor) + "/supervision";
  }
}
