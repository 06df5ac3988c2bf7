package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.toqa.fleet.PathAnswer;
import org.toqa.fleet.PathQuestion;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;

/** How a robot gets from here to there, and how far that is. */
public final class PathResource extends ApiHandler {
  /** Metres, as {@code 3.45,9.15}; anything else is a station's name. */
  private static final Pattern POINT =
      Pattern.compile("(-?\\d{1,6}(?:\\.\\d{1,6})?),(-?\\d{1,6}(?:\\.\\d{1,6})?)");

  private record PathJson(String floor, double metres, List<Vec2> points) {
    static PathJson of(PathAnswer path) {
      return new PathJson(path.floor(), path.metres(), path.points());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    PathQuestion question =
        new PathQuestion(
            floor(request).name(), place(request, "start", errors), place(request, "goal", errors));
    throwIfAny(errors);
    PathAnswer path =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request).fleet().path(question, Caller.of(request).name())));
    Json.send(request, response, 200, PathJson.of(path));
  }

  private static Where place(HttpServletRequest request, String field, FieldErrors errors) {
    String given = request.getParameter(field);
    if (given == null || given.isBlank()) {
      errors.add(field, Texts.of(request).get("error.path.place"));
      return new Where.Station("");
    }
    Matcher point = POINT.matcher(given.strip());
    return point.matches()
        ? new Where.Point(
            new Vec2(Double.parseDouble(point.group(1)), Double.parseDouble(point.group(2))))
        : new Where.Station(given.strip());
  }
}
