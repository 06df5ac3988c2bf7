package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.exploration.ExplorationOrder;
import org.toqa.exploration.HiddenGround;
import org.toqa.fleet.Answer;
import org.toqa.fleet.exploration.Exploration;
import org.toqa.fleet.exploration.Explorer;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;
import org.toqa.web.input.ExplorationReader;
import org.toqa.web.input.FieldErrors;

/** The exploration of a floor: a form to start one, and the last one with what it saw. */
public final class ExplorationPage extends PageHandler {
  private static final String GONE = "floors.gone";

  /**
   * A ground as the form offers it.
   *
   * @param value of the field
   * @param scene its word; null: it is the map of a floor
   * @param name of that floor; null: it is a scene
   * @param width metres
   * @param height metres
   */
  public record Ground(
      String value, @Nullable String scene, @Nullable String name, double width, double height) {
    static Ground of(HiddenGround ground) {
      OccupancyGrid grid = ground.grid();
      return new Ground(
          Explorer.SCENE + ground.word(),
          ground.word(),
          null,
          grid.width() * grid.resolution(),
          grid.height() * grid.resolution());
    }

    static Ground of(FloorMap floor) {
      OccupancyGrid grid = floor.grid();
      return new Ground(
          Explorer.FLOOR + floor.name(),
          null,
          floor.name(),
          grid.width() * grid.resolution(),
          grid.height() * grid.resolution());
    }
  }

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (addAttributes(request)) {
      show(request, response, "exploration");
    } else {
      sendNotFound(request, response, GONE);
    }
  }

  /** False: there is no such floor. */
  private static boolean addAttributes(HttpServletRequest request) {
    String floor = floor(request);
    List<FloorMap> floors = services(request).fleet().floors();
    if (floors.stream().noneMatch(one -> one.name().equals(floor))) {
      return false;
    }
    request.setAttribute("floor", floor);
    request.setAttribute("segment", RequestPath.segment(floor));
    request.setAttribute("mostRobots", ExplorationOrder.MOST_ROBOTS);
    Optional<Exploration> last = services(request).explorer().latest(floor);
    request.setAttribute(
        "proposed",
        last.map(Exploration::order)
            .orElse(
                new ExplorationOrder(
                    1, HiddenGround.OFFICE.start(), HiddenGround.OFFICE.target(), 1)));
    request.setAttribute(
        "grounds",
        Stream.concat(
                Arrays.stream(HiddenGround.values()).map(Ground::of),
                floors.stream().map(Ground::of))
            .toList());
    last.ifPresent(exploration -> request.setAttribute("exploration", exploration));
    return true;
  }

  private static String floor(HttpServletRequest request) {
    return RequestPath.parameter(request, "floor");
  }

  public static void start(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (!addAttributes(request)) {
      sendNotFound(request, response, GONE);
      return;
    }
    FieldErrors errors = new FieldErrors();
    Optional<Exploration> begun =
        readForm(request, errors, ExplorationReader::readForm)
            .flatMap(
                order ->
                    acceptedValue(
                        request,
                        inForm(
                            services(request)
                                .explorer()
                                .start(
                                    floor(request),
                                    order.ground(),
                                    order.order(),
                                    Caller.of(request).name())),
                        errors));
    if (begun.isPresent()) {
      redirect(request, response, address(request));
    } else {
      showAgain(request, response, "exploration", errors);
    }
  }

  /** A point has two fields in the form. */
  private static <T> Answer<T> inForm(Answer<T> answer) {
    return answer instanceof Answer.Rejected<T>(String field, var sentence)
            && ("start".equals(field) || "target".equals(field))
        ? new Answer.Rejected<>(field + "X", sentence)
        : answer;
  }

  public static void stop(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    showUnlessDone(
        request,
        response,
        () ->
            FleetAnswers.await(
                services(request).explorer().stop(floor(request), Caller.of(request).name())));
  }

  /** What was seen becomes the draft, whatever is drawn there. */
  public static void draw(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    showUnlessDone(
        request,
        response,
        () ->
            FleetAnswers.await(
                services(request).explorer().draw(floor(request), Caller.of(request).name())));
  }

  private static void showUnlessDone(
      HttpServletRequest request,
      HttpServletResponse response,
      Supplier<Answer<Exploration>> command)
      throws ServletException, IOException {
    if (!addAttributes(request)) {
      sendNotFound(request, response, GONE);
      return;
    }
    FieldErrors errors = new FieldErrors();
    if (acceptedValue(request, command.get(), errors).isPresent()) {
      redirect(request, response, address(request));
    } else {
      showConflict(request, response, "exploration", errors);
    }
  }

  private static String address(HttpServletRequest request) {
    return "/floors/" + RequestPath.segment(floor(request)) + "/exploration";
  }
}
