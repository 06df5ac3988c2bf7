package org.toqa.web.api;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.grid.FloorMap;
import org.toqa.mission.Question;
import org.toqa.web.FieldErrors;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.Version;
import org.toqa.wording.Sentence;

/** What the servlets of the API have in common: raised problems become answers. */
abstract class ApiServlet extends HttpServlet {

  @Override
  protected void service(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    try {
      super.service(request, response);
    } catch (Problem.Raised e) {
      e.problem().send(request, response);
    } catch (StoreException e) {
      Problem.of(503, Texts.of(request).get("problem.databaseAway")).send(request, response);
    }
  }

  final Services services() {
    return Services.from(getServletContext());
  }

  /**
   * @throws Problem.Raised when there are errors
   */
  static void refuseIfAny(FieldErrors errors) {
    if (!errors.isEmpty()) {
      throw Problem.of(errors).raised();
    }
  }

  /**
   * @throws Problem.Raised when the caller means another version than this
   */
  static void refuseOther(Version version, HttpServletRequest request) {
    String wanted = request.getHeader("If-Match");
    if (wanted != null && !version.isAmong(wanted)) {
      throw Problem.of(412, Texts.of(request).get("problem.changedMeanwhile")).raised();
    }
  }

  /**
   * @throws Problem.Raised when the fleet says no
   */
  static <T> T accepted(HttpServletRequest request, Answer<T> answer) {
    Texts texts = Texts.of(request);
    return switch (answer) {
      case Answer.Accepted<T>(T value) -> value;
      case Answer.Refused<T>(String field, Sentence sentence) -> {
        if (field == null) {
          throw Problem.of(422, texts.say(sentence)).raised();
        }
        FieldErrors errors = new FieldErrors();
        errors.add(field, texts.say(sentence));
        throw Problem.of(errors).raised();
      }
      case Answer.Conflict<T>(Sentence sentence, Question needs) ->
          throw Problem.conflict(texts.say(sentence), needs).raised();
      case Answer.Unknown<T>(Sentence sentence) ->
          throw Problem.of(404, texts.say(sentence)).raised();
    };
  }

  /** The floor that the query names; the first one where it names none. */
  final FloorMap floor(HttpServletRequest request) {
    List<FloorMap> floors = services().fleet().floors();
    String wanted = request.getParameter("floor");
    return floors.stream()
        .filter(floor -> wanted == null || floor.name().equals(wanted))
        .findFirst()
        .orElseThrow(() -> noSuchFloor(request, floors));
  }

  private static Problem.Raised noSuchFloor(HttpServletRequest request, List<FloorMap> floors) {
    String names = floors.stream().map(FloorMap::name).collect(Collectors.joining(", "));
    return Problem.of(404, Texts.of(request).get("problem.noSuchFloor", names)).raised();
  }

  /** A whole number from the query, at least {@code least}; a larger one than most is lowered. */
  static int queryNumber(
      HttpServletRequest request, String name, int otherwise, int least, int most) {
    String given = request.getParameter(name);
    if (given == null) {
      return otherwise;
    }
    if (!given.matches("[0-9]{1,9}") || Integer.parseInt(given) < least) {
      throw Problem.of(400, Texts.of(request).get("problem.queryNumber", name, least)).raised();
    }
    return Math.min(Integer.parseInt(given), most);
  }
}
